// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/geometry/point2.h"

namespace agrid {

/// When the estimated direction is believed. Defaults keep every upright map upright.
struct DirectionParams {
  double snap_deg = 0.75;   ///< smaller directions count as 0: a wall of 75 pixels drifts by one
  double min_gain = 2;      ///< how much sharper the profile must be than the one at 0
  double min_contrast = 3;  ///< how much sharper it must be than at a typical direction
};

/// The direction along which a building's walls lie, from points on its walls.
///
/// Points on a wall pile up at one place when they are projected along it. So the direction is the
/// one whose two profiles (projections to x and y of the frame turned by it) are sharpest, measured
/// by the sum of squared differences of neighbouring bins: first over all directions with coarse
/// bins, then around the best with fine ones, 0.05 degrees apart. Not in the paper, whose maps were
/// upright.
/// @param points  any unit, one per edge pixel at a spacing of about 1; all of them are used
/// @return radians in (-pi/4, pi/4], counter-clockwise; exactly 0 if there are fewer than two
///         points, or if the direction is small or not clear
double mainDirection(const std::vector<Point2>& points, const DirectionParams& params = {});

}  // namespace agrid
