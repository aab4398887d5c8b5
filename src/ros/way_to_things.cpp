// SPDX-License-Identifier: BSD-3-Clause
#include "ros/way_to_things.h"

#include <algorithm>
#include <utility>

namespace agrid_map_ros {
namespace {

/// How far from the middle of a thing a robot may stop to be there [m].
constexpr double kReach = 1.0;

struct Position {
  agrid::Point2 operator()(const agrid::Area* area) const { return area->anchor_map; }
  agrid::Point2 operator()(const agrid::Door* door) const { return door->jambs_map.midpoint(); }
  agrid::Point2 operator()(const agrid::ObjectTag* object) const {
    return object->pose_map.position;
  }
};

/// How far a goal at a thing's position may be moved [m].
struct Reach {
  double operator()(const agrid::Area*) const { return 0; }
  double operator()(const agrid::Door*) const { return kReach; }
  double operator()(const agrid::ObjectTag* object) const {
    return kReach + object->size.norm() / 2;
  }
};

}  // namespace

agrid::Point2 positionOf(const Thing& thing) { return std::visit(Position{}, thing); }

agrid::PlanRequest requestTo(const Thing& thing, const agrid::PlanRequest& base, bool at_anchor) {
  agrid::PlanRequest request = base;
  if (const auto* area = std::get_if<const agrid::Area*>(&thing)) {
    request.goal = agrid::AreaGoal{(*area)->id, at_anchor};
  } else {
    request.goal = agrid::PlanPoint{positionOf(thing), std::nullopt};
    request.tolerance = std::max(base.tolerance, std::visit(Reach{}, thing));
  }
  return request;
}

agrid::Plan planToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                          const agrid::PlanRequest& base, bool at_anchor) {
  agrid::Plan best = planner.plan(requestTo(things.at(0), base, at_anchor));
  double seconds = best.planning_time;
  for (std::size_t i = 1; i < things.size(); ++i) {
    agrid::Plan plan = planner.plan(requestTo(things[i], base, at_anchor));
    seconds += plan.planning_time;
    const bool better = best.status != agrid::PlanStatus::kSuccess || plan.length < best.length;
    if (plan.status == agrid::PlanStatus::kSuccess && better) best = std::move(plan);
  }
  best.planning_time = seconds;
  return best;
}

agrid::RouteList routesToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                                 const agrid::PlanRequest& base, std::size_t max_routes) {
  agrid::RouteList best = planner.routes(requestTo(things.at(0), base, false), max_routes);
  for (std::size_t i = 1; i < things.size(); ++i) {
    agrid::RouteList list = planner.routes(requestTo(things[i], base, false), max_routes);
    if (list.routes.empty()) continue;
    const bool better =
        best.routes.empty() || list.routes.front().length < best.routes.front().length;
    if (better) best = std::move(list);
  }
  return best;
}

}  // namespace agrid_map_ros
