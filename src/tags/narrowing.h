// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/segment.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// The narrowest place around a pixel, from wall to wall: to the nearest wall, and to the nearest
/// one opposite, moved along the walls to where they face each other the closest.
/// @param center  a pixel with a height above 0
/// @param height  row-major; distance from the walls [px], 0 = wall
/// @return between the walls' surfaces, image frame in pixels, pixel (x, y) covering
///         [x, x + 1) x [y, y + 1)
Segment findNarrowing(Pixel center, const cv::Mat1f& height);

}  // namespace agrid
