// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/segment.h"
#include "areas/borders.h"

namespace agrid {

/// The narrowest place of a border between two areas.
struct Narrowing {
  Segment jambs_px;      ///< from wall to wall, on the walls' surface, image frame [px]
  double height_px = 0;  ///< of the relief where the border is farthest from the walls [px]
};

/// Finds the walls on both sides of the border's farthest point from the walls: the nearest one,
/// and the nearest one opposite, moved along the walls to where they face each other the closest.
/// @param height  relief that the areas were grown on; 0 = wall
Narrowing findNarrowing(const Stretch& stretch, const cv::Mat1f& height,
                        const MapGeometry& geometry);

}  // namespace agrid
