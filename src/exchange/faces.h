// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "agrid/semantic_map.h"

namespace agrid {

/// A closed line along the sides of pixels, the first corner not repeated: pixel (x, y) covers
/// [x, x + 1) x [y, y + 1). It meets itself nowhere, and turns at every corner.
using PixelRing = std::vector<cv::Point>;

/// Pixels that hang together by their sides, exactly: rings touch each other in single points at
/// most, so that it is a valid polygon of OGC's simple features.
struct Face {
  PixelRing outer;               ///< counter-clockwise (y up)
  std::vector<PixelRing> holes;  ///< clockwise
};

/// The parts of a shape.
/// @param shape  row-major, row 0 = smallest y; 1 = part of the shape, 0 = not
/// @param origin  where pixel (0, 0) of the shape lies
std::vector<Face> facesOf(const cv::Mat1b& shape, const cv::Point& origin = {});

/// The parts of each area of a map, in the areas' order; none of one without pixels.
std::vector<std::vector<Face>> areaFaces(const SemanticMap& map);

/// A ring's corners in the map frame [m].
Polygon mapPolygon(const PixelRing& ring, const MapGeometry& geometry);

}  // namespace agrid
