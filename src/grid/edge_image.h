// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "agrid/grid/wall_detection.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// The map as a picture, CV_8UC1: free 254, unknown 205, occupied 0. Row 0 is the top, the largest
/// y, as in image files: the edge detector and the Hough transform break ties by rows and columns,
/// and this is how the paper saw its maps.
cv::Mat drawForEdges(const OccupancyMap& map);

/// The edges of that picture (paper, 3.1: Canny, thresholds 1 and 30), CV_8UC1, 255 on an edge.
cv::Mat detectEdges(const OccupancyMap& map, const WallParams& params);

}  // namespace agrid
