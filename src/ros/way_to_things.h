// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/planning/planner.h"
#include "agrid/semantic_map/thing_lookup.h"
#include "ros/time_limit.h"

namespace agrid_map_ros {

/// A request for the way to a thing: to the nearest point or the anchor of an area, to the middle
/// of a door, to where the robot can stand beside an object.
/// @param base  all but the goal
agrid::PlanRequest requestTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                             bool at_anchor);

/// Looks for the nearest of some things within a time limit.
struct WayFinder {
  const agrid::Planner& planner;
  const TimeLimit& limit;
  /// Where it is known, places in the object's own area come first, as one may be nearer behind a
  /// wall.
  const agrid::SemanticMap* map = nullptr;

  /// The way to a thing. To an object it ends beside its box and faces its centre, at the first of
  /// the places around it that can be reached: those of its own area first, then those near to both
  /// it and the start. Where none can be, the way is that of requestTo, and the message says so.
  /// @param base  all but goal and timeout
  agrid::Plan planTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                     bool at_anchor) const;
  /// The routes to where planTo() ends, and the same statuses.
  agrid::RouteList routesTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                            std::size_t max_routes) const;

  /// The shortest of the ways to the things; if none can be reached, what is said of the first. The
  /// message tells if the time was over before all were looked at.
  /// @param base  all but goal and timeout
  agrid::Plan planToNearest(const std::vector<agrid::Thing>& things, const agrid::PlanRequest& base,
                            bool at_anchor) const;
  /// The same for routes: those to the thing with the shortest one.
  agrid::RouteList routesToNearest(const std::vector<agrid::Thing>& things,
                                   const agrid::PlanRequest& base, std::size_t max_routes) const;

  /// `base` for one thing, with the time that is left.
  agrid::PlanRequest timedRequestTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                                    bool at_anchor) const;
};

}  // namespace agrid_map_ros
