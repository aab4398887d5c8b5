// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/planning/planner.h"
#include "ros/thing_lookup.h"

namespace agrid_map_ros {

/// Where a thing lies, map frame [m]: an area's anchor, a door's middle, an object's centre.
agrid::Point2 positionOf(const Thing& thing);

/// A request for the way to a thing: to the nearest point or the anchor of an area, to the middle
/// of a door, to where the robot can stand beside an object.
/// @param base  all but the goal
agrid::PlanRequest requestTo(const Thing& thing, const agrid::PlanRequest& base, bool at_anchor);

/// The shortest of the ways to some things; if none can be reached, what is said of the first.
/// @param base  all but the goal
agrid::Plan planToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                          const agrid::PlanRequest& base, bool at_anchor);
/// The same for routes: those to the thing with the shortest one.
agrid::RouteList routesToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                                 const agrid::PlanRequest& base, std::size_t max_routes);

}  // namespace agrid_map_ros
