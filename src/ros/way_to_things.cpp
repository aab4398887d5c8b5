// SPDX-License-Identifier: BSD-3-Clause
#include "ros/way_to_things.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "agrid/semantic_map/object_area.h"

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

/// A place around an object; the one with the lowest cost is tried first.
struct Place {
  agrid::PlanPoint point;
  double cost = 0;
};

/// Places around an object's box that face its centre, the best ones first.
/// @param radius  the robot's [m]
std::vector<Place> placesBeside(const agrid::ObjectTag& object, const agrid::Point2& start_map,
                                double radius, const agrid::SemanticMap* map) {
  constexpr int kDirections = 16;
  constexpr double kWeightOfGap = 3;  // rather a longer way than a stop far off
  constexpr double kOtherArea = 1e6;  // [m], beyond every way
  const agrid::Area* home = map ? agrid::areaOf(*map, object) : nullptr;
  const agrid::Point2 half = object.size / 2;
  std::vector<Place> places;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / kDirections;
    const agrid::Point2 away(std::cos(angle), std::sin(angle));
    const double rim = std::min(half.x() / std::max(std::abs(away.x()), 1e-9),
                                half.y() / std::max(std::abs(away.y()), 1e-9));
    for (const double gap : {0.05, 0.15, 0.3, 0.5, 0.75, kReach}) {
      Place place;
      place.point.position_map = object.pose_map * agrid::Point2(away * (rim + radius + gap));
      const agrid::Point2 look = object.pose_map.position - place.point.position_map;
      place.point.yaw = std::atan2(look.y(), look.x());
      place.cost = (place.point.position_map - start_map).norm() + kWeightOfGap * gap;
      if (home && agrid::areaAt(*map, place.point.position_map) != home) place.cost += kOtherArea;
      places.push_back(place);
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.cost < b.cost; });
  return places;
}

agrid::PlanRequest movedTo(const agrid::Pose2& start_map, agrid::PlanRequest request) {
  request.start.position_map = start_map.position;
  return request;
}

/// What `ask` answers, a plan or routes, for the best place beside an object, see
/// WayFinder::planTo.
template <typename Ask, typename Answer = std::invoke_result_t<Ask, const agrid::PlanRequest&>>
Answer askBeside(const WayFinder& ways, const agrid::ObjectTag& object,
                 const agrid::PlanRequest& base, const Ask& ask) {
  constexpr int kMostWithoutRoute = 8;  // it takes a while to say why there is none
  using agrid::PlanStatus;
  const auto near = [&] { return ways.timedRequestTo(&object, base, false); };
  int without_route = 0;
  const double radius = base.robot_radius.value_or(ways.planner.circleRadius());
  for (const Place& place : placesBeside(object, base.start.position_map, radius, ways.map)) {
    agrid::PlanRequest request = near();
    request.goal = place.point;
    request.tolerance = 0;
    Answer answer = ask(request);
    if (answer.status == PlanStatus::kSuccess) {
      answer.message = "ends beside '" + object.name + "' and faces it";
      return answer;
    }
    if (answer.status == PlanStatus::kStartInvalid && base.tolerance > 0) {
      // the start may be moved, but not farther than asked for, and the place may not
      request.tolerance = base.tolerance;
      const agrid::Plan plan = ways.planner.plan(request);
      if (plan.start_moved) {
        answer = askBeside(ways, object, movedTo(plan.path_map.front(), base), ask);
        if constexpr (std::is_same_v<Answer, agrid::Plan>) answer.start_moved = true;
        return answer;
      }
      answer.status = plan.status;
      answer.message = plan.message;
    }
    if (answer.status == PlanStatus::kStartInvalid) return answer;
    const bool no_route = answer.status == PlanStatus::kNoRoute;
    if (!no_route && answer.status != PlanStatus::kGoalInvalid) break;
    if (no_route && ++without_route == kMostWithoutRoute) break;
  }
  Answer answer = ask(near());
  if (answer.status == PlanStatus::kSuccess) {
    answer.message = "no free place beside '" + object.name + "' can be reached; ends near it";
  }
  return answer;
}

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

agrid::Plan WayFinder::planTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                              bool at_anchor) const {
  const auto plan = [this](const agrid::PlanRequest& request) { return planner.plan(request); };
  if (const auto* object = std::get_if<const agrid::ObjectTag*>(&thing)) {
    return askBeside(*this, **object, base, plan);
  }
  return plan(timedRequestTo(thing, base, at_anchor));
}

agrid::RouteList WayFinder::routesTo(const agrid::Thing& thing, const agrid::PlanRequest& base,
                                     std::size_t max_routes) const {
  const auto list = [&](const agrid::PlanRequest& request) {
    return planner.routes(request, max_routes);
  };
  if (const auto* object = std::get_if<const agrid::ObjectTag*>(&thing)) {
    return askBeside(*this, **object, base, list);
  }
  return list(timedRequestTo(thing, base, false));
}

agrid::Plan WayFinder::planToNearest(const std::vector<agrid::Thing>& things,
                                     const agrid::PlanRequest& base, bool at_anchor) const {
  agrid::Plan best = planTo(things.at(0), base, at_anchor);
  double seconds = best.planning_time;
  for (std::size_t i = 1; i < things.size(); ++i) {
    if (limit.isOver()) {
      best.message += overAfter(i, things.size(), best.message);
      break;
    }
    agrid::Plan plan = planTo(things[i], base, at_anchor);
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
  agrid::RouteList best = routesTo(things.at(0), base, max_routes);
  for (std::size_t i = 1; i < things.size(); ++i) {
    if (limit.isOver()) {
      best.message += overAfter(i, things.size(), best.message);
      break;
    }
    agrid::RouteList list = routesTo(things[i], base, max_routes);
    if (list.routes.empty()) continue;
    const bool better =
        best.routes.empty() || list.routes.front().length < best.routes.front().length;
    if (better) best = std::move(list);
  }
  return best;
}

}  // namespace agrid_map_ros
