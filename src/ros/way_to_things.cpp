// SPDX-License-Identifier: BSD-3-Clause
#include "ros/way_to_things.h"

#include <algorithm>
#include <string>
#include <utility>

namespace agrid_map_ros {
namespace {

/// How far from the middle of a thing a robot may stop to be there [m].
constexpr double kReach = 1.0;

/// How far a goal at a thing's position may be moved [m].
struct Reach {
  double operator()(const agrid::Area*) const { return 0; }
  double operator()(const agrid::Door*) const { return kReach; }
  double operator()(const agrid::ObjectTag* object) const {
    return kReach + object->size.norm() / 2;
  }
};

std::string overAfter(std::size_t count, std::size_t all, const std::string& message) {
  return (message.empty() ? "" : "; ") + std::string("the time was over after ") +
         std::to_string(count) + " of " + std::to_string(all) + " places";
}

}  // namespace

agrid::PlanRequest requestTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                             bool at_anchor) {
  agrid::PlanRequest request = base;
  if (const auto* area = std::get_if<const agrid::Area*>(&thing)) {
    request.goal = agrid::AreaGoal{(*area)->id, at_anchor};
  } else {
    request.goal = agrid::PlanPoint{positionOf(thing), std::nullopt};
    request.tolerance = std::max(base.tolerance, std::visit(Reach{}, thing));
  }
  return request;
}

agrid::PlanRequest WayFinder::timedRequestTo(const agrid::Thing& thing,
                                             const agrid::PlanRequest& base, bool at_anchor) const {
  agrid::PlanRequest request = requestTo(thing, base, at_anchor);
  request.timeout = limit.left();
  return request;
}

agrid::Plan WayFinder::planToNearest(const std::vector<agrid::Thing>& things,
                                     const agrid::PlanRequest& base, bool at_anchor) const {
  agrid::Plan best = planner.plan(timedRequestTo(things.at(0), base, at_anchor));
  double seconds = best.planning_time;
  for (std::size_t i = 1; i < things.size(); ++i) {
    if (limit.isOver()) {
      best.message += overAfter(i, things.size(), best.message);
      break;
    }
    agrid::Plan plan = planner.plan(timedRequestTo(things[i], base, at_anchor));
    seconds += plan.planning_time;
    const bool better = best.status != agrid::PlanStatus::kSuccess || plan.length < best.length;
    if (plan.status == agrid::PlanStatus::kSuccess && better) best = std::move(plan);
  }
  best.planning_time = seconds;
  return best;
}

agrid::RouteList WayFinder::routesToNearest(const std::vector<agrid::Thing>& things,
                                            const agrid::PlanRequest& base,
                                            std::size_t max_routes) const {
  agrid::RouteList best = planner.routes(timedRequestTo(things.at(0), base, false), max_routes);
  for (std::size_t i = 1; i < things.size(); ++i) {
    if (limit.isOver()) {
      best.message += overAfter(i, things.size(), best.message);
      break;
    }
    agrid::RouteList list = planner.routes(timedRequestTo(things[i], base, false), max_routes);
    if (list.routes.empty()) continue;
    const bool better =
        best.routes.empty() || list.routes.front().length < best.routes.front().length;
    if (better) best = std::move(list);
  }
  return best;
}

}  // namespace agrid_map_ros
