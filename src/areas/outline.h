// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/polygon.h"
#include "tags/pixel_runs.h"

namespace agrid {

/// The outer boundary of the largest 4-connected part of a shape, along the sides of its pixels,
/// simplified to one pixel; as it is if it is too thin for that.
/// @param shape  row-major, row 0 = smallest y; 1 = part of the shape, 0 = not
/// @return corners in pixels, counter-clockwise, pixel (x, y) covering [x, x + 1) x [y, y + 1);
///         empty if the shape is
Polygon traceOutline(const cv::Mat1b& shape);

/// Whether a pixel, perhaps outside of the map, belongs to a shape.
using IsInside = std::function<bool(const cv::Point&)>;

/// The same of a shape that is no image.
/// @param runs  all of the shape, as findRuns returns them
Polygon traceOutline(const std::vector<PixelRun>& runs, const IsInside& inside);

}  // namespace agrid
