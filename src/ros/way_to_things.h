// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/planning/planner.h"
#include "ros/thing_lookup.h"

namespace agrid_map_ros {

/// Where a thing lies, map frame [m]: an area's anchor, a door's middle, an object's centre.
agrid::Point2 positionOf(const Thing& thing);

/// The way to a thing: to the nearest point or the anchor of an area, to the middle of a door, to
/// where the robot can stand beside an object.
/// @param request  all but the goal
agrid::Plan planTo(const agrid::Planner& planner, const Thing& thing,
                   const agrid::PlanRequest& request, bool at_anchor);

/// The shortest of the ways to some things; if none can be reached, the first thing's plan.
agrid::Plan planToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                          const agrid::PlanRequest& request, bool at_anchor);

}  // namespace agrid_map_ros
