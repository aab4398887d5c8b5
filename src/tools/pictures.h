// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "agrid/semantic_map.h"

namespace agrid::tools {

/// The edges of a map (8-bit, 255 on an edge) as a picture.
cv::Mat drawEdges(const cv::Mat& edges);
/// Wall lines over the metric map.
cv::Mat drawWalls(const Structure& structure);
/// The cells of the A-Grid over the metric map.
cv::Mat drawGrid(const Structure& structure);
/// Areas in colours with their names, doors in blue.
cv::Mat drawAreas(const SemanticMap& map);
/// The topological graph over the metric map.
cv::Mat drawGraph(const SemanticMap& map);
/// The metric map beside what was made of it.
cv::Mat drawOverview(const SemanticMap& map);

}  // namespace agrid::tools
