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

agrid::Plan planTo(const agrid::Planner& planner, const Thing& thing,
                   const agrid::PlanRequest& request, bool at_anchor) {
  agrid::PlanRequest wanted = request;
  if (const auto* area = std::get_if<const agrid::Area*>(&thing)) {
    wanted.goal = agrid::AreaGoal{(*area)->id, at_anchor};
  } else {
    wanted.goal = agrid::PlanPoint{positionOf(thing), std::nullopt};
    wanted.tolerance = std::max(request.tolerance, std::visit(Reach{}, thing));
  }
  return planner.plan(wanted);
}

agrid::Plan planToNearest(const agrid::Planner& planner, const std::vector<Thing>& things,
                          const agrid::PlanRequest& request, bool at_anchor) {
  agrid::Plan best = planTo(planner, things.at(0), request, at_anchor);
  double seconds = best.planning_time;
  for (std::size_t i = 1; i < things.size(); ++i) {
    agrid::Plan plan = planTo(planner, things[i], request, at_anchor);
    seconds += plan.planning_time;
    const bool better = best.status != agrid::PlanStatus::kSuccess || plan.length < best.length;
    if (plan.status == agrid::PlanStatus::kSuccess && better) best = std::move(plan);
  }
  best.planning_time = seconds;
  return best;
}

}  // namespace agrid_map_ros
