// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <ompl/base/StateSpace.h>

#include "agrid/planning/planner.h"
#include "planning/ompl/swept_robot.h"
#include "planning/stop.h"

namespace agrid::planning {

/// The space of a robot's motions: Reeds and Shepp's curves, Dubins' curves, or, without a turning
/// radius, turning on the spot and driving straight.
ompl::base::StateSpacePtr curveSpace(double turning_radius, Motion motion);

/// What a robot is asked for that cannot turn on the spot, or whose outline is no circle.
struct TurningQuery {
  double turning_radius = 0;  ///< [m]; 0: it turns on the spot
  Motion motion = Motion::kReedsShepp;
  std::vector<Point2> lead_map;  ///< from start to goal; at least one corner
  /// Another lead from start to goal, asked for if the first does not help at once; may be empty.
  std::function<std::vector<Point2>()> detour_map;
  std::optional<double> start_yaw;
  std::optional<double> goal_yaw;
  std::uint32_t seed = 0;
};

/// Poses along a path that the robot can drive. Straight lines between them stay as far from what
/// is not free as the path itself: they are at most 2 pixels apart, on arcs so near that a straight
/// line leaves the arc by 1/100 pixel at most.
/// @return map frame; empty if none was found in time
/// @throws Stopped if cancelled
std::vector<Pose2> planTurning(const std::shared_ptr<const SweptRobot>& robot,
                               const TurningQuery& query, const StopCheck& stop);

}  // namespace agrid::planning
