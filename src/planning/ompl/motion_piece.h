// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "agrid/geometry/pose2.h"

namespace agrid::planning {

/// A part of a robot's motion with constant curvature: an arc, a straight line (on which the
/// heading may turn evenly, as in OMPL's SE2StateSpace), or a turn on the spot. In the map frame
/// [m], or in pixels where said.
struct MotionPiece {
  Pose2 from;
  double length = 0;     ///< way of the robot's origin; on an arc negative when driven backwards
  double turn = 0;       ///< change of heading [rad]
  bool is_arc = false;   ///< the origin follows the heading
  double direction = 0;  ///< of travel, unless it is an arc [rad]

  /// @param t  share of the piece, in [0, 1]
  Pose2 at(double t) const {
    const double h = from.yaw;
    const double yaw = h + turn * t;
    if (!is_arc || std::abs(turn) < 1e-9) {
      const double along = is_arc ? h : direction;
      return {from.position + length * t * Point2(std::cos(along), std::sin(along)), yaw};
    }
    const double radius = length / turn;
    return {
        from.position + radius * Point2(std::sin(yaw) - std::sin(h), std::cos(h) - std::cos(yaw)),
        yaw};
  }
  double curvature() const { return is_arc && length != 0 ? std::abs(turn / length) : 0; }
};

}  // namespace agrid::planning
