// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "planning/blocking_doors.h"
#include "planning/forbidden_between.h"
#include "planning/planner_core.h"

namespace agrid::planning {

/// A robot that stands in a forbidden area must be able to leave it: that one is open to it.
Task PlannerCore::taskOf(const PlanRequest& request, const Query& query,
                         const StopCheck& stop) const {
  Task task;
  const Point2& start_map = request.start.position_map;
  const std::uint16_t open_area = forbiddenAt(start_map);
  task.level = levels_->get(query.robot_radius, open_area, stop);
  const Departure from{chooseEndpoints(*task.level, obstacles_, start_map, request.tolerance),
                       query.robot_radius, request.tolerance, open_area, stop};
  const auto* area_goal = std::get_if<AreaGoal>(&request.goal);
  const std::size_t area = area_goal != nullptr ? areaIndex(area_goal->area) : 0;
  if (from.starts.places.empty()) {
    throw Refusal{PlanStatus::kStartInvalid, "the start " + from.starts.problem};
  }
  if (area_goal == nullptr) {
    const auto& goal = std::get<PlanPoint>(request.goal);
    task.goal_yaw = goal.yaw;
    return taskToPoint(std::move(task), from, goal.position_map);
  }
  const KeepOut* keep_out = levels_->keepOut();
  if (keep_out != nullptr && keep_out->forbids(static_cast<std::uint16_t>(area + 1))) {
    throw Refusal{PlanStatus::kGoalInvalid,
                  "the area '" + map_->area_map.areas[area].name + "' is forbidden"};
  }
  if (area_goal->at_anchor) {
    return taskToPoint(std::move(task), from, map_->area_map.areas[area].anchor_map);
  }
  return taskToArea(std::move(task), from, area);
}

Task PlannerCore::taskToPoint(Task task, const Departure& from, const Point2& goal_map) const {
  const EndpointChoice goals = goalsAt(*task.level, from, goal_map);
  if (goals.places.empty()) {
    throw Refusal{PlanStatus::kGoalInvalid, "the goal " + goals.problem};
  }
  const auto pair = connectedPair(from.starts, goals);
  if (!pair) {
    Target goal;
    goal.point = goals.places.front().point;
    throw Refusal{PlanStatus::kNoRoute, whyApart(from, goal)};
  }
  task.start = pair->first;
  task.target.point = pair->second.point;
  task.target.regions = {pair->second.region};
  task.target.box.add(pair->second.point.pixel());
  task.goal_moved = pair->second.moved;
  return task;
}

/// No goal lies in a forbidden area, not even in the one that the robot may leave.
EndpointChoice PlannerCore::goalsAt(const RadiusLevel& level, const Departure& from,
                                    const Point2& goal_map) const {
  EndpointChoice goals = chooseEndpoints(level, obstacles_, goal_map, from.tolerance);
  const MapGeometry& geometry = map_->map().geometry();
  const auto isForbidden = [&](const Endpoint& place) {
    const std::size_t pixel = geometry.index(place.point.pixel());
    return map_->area_map.pixel_labels[pixel] == from.open_area;
  };
  if (from.open_area != 0) {
    goals.places.erase(std::remove_if(goals.places.begin(), goals.places.end(), isForbidden),
                       goals.places.end());
  }
  const std::uint16_t label = forbiddenAt(goal_map);
  if (goals.places.empty() && label != 0) {
    goals.problem = "lies in the forbidden area '" + map_->area_map.areas[label - 1U].name + "'";
  }
  return goals;
}

Task PlannerCore::taskToArea(Task task, const Departure& from, std::size_t area) const {
  Target target = areaTarget(*task.level, static_cast<std::uint16_t>(area + 1));
  const PortalGraph& regions = task.level->roadmap.regions();
  const std::set<std::uint32_t> components = componentsOf(target, regions);
  if (components.empty()) {
    throw Refusal{PlanStatus::kGoalInvalid, "the robot's centre fits nowhere in the area '" +
                                                map_->area_map.areas[area].name + "'"};
  }
  for (const Endpoint& place : from.starts.places) {
    if (components.count(place.component) == 0) continue;
    task.start = place;
    task.target = reachablePart(std::move(target), regions, place.component);
    return task;
  }
  throw Refusal{PlanStatus::kNoRoute, whyApart(from, target)};
}

std::size_t PlannerCore::areaIndex(AreaId id) const {
  const Area* area = findArea(*map_, id);
  if (area == nullptr) {
    throw Refusal{PlanStatus::kUnknownName,
                  "no area has the id " + std::to_string(static_cast<std::uint32_t>(id))};
  }
  return static_cast<std::size_t>(area - map_->area_map.areas.data());
}

std::uint16_t PlannerCore::forbiddenAt(const Point2& point_map) const {
  if (levels_->keepOut() == nullptr || !point_map.allFinite()) return 0;
  const MapGeometry& geometry = map_->map().geometry();
  const auto pixel = geometry.pixelAt(point_map);
  if (!pixel) return 0;
  const std::uint16_t label = map_->area_map.pixel_labels[geometry.index(*pixel)];
  return levels_->keepOut()->forbids(label) ? label : std::uint16_t{0};
}

/// Doors, where they keep the two apart even if nothing were forbidden.
std::string PlannerCore::whyApart(const Departure& from, const Target& goal) const {
  const auto open = levels_->get(from.robot_radius, kAllEntered, from.stop);
  const PortalGraph& regions = open->roadmap.regions();
  const auto componentAt = [&](FinePoint p) {
    return regions.componentOf(regions.nodeAt(map_->map().geometry().index(p.pixel())));
  };
  const std::uint32_t start = componentAt(from.starts.places.front().point);
  std::set<std::uint32_t> goals;
  if (goal.point) {
    goals = {componentAt(*goal.point)};
  } else {
    goals = componentsOf(areaTarget(*open, goal.label), regions);
  }
  std::string text = explainNoRoute(*map_, *open, obstacles_, start, {goals.begin(), goals.end()});
  if (goals.count(start) != 0) text += forbiddenInTheWay(from, goal, *open);
  return text;
}

std::string PlannerCore::forbiddenInTheWay(const Departure& from, const Target& goal,
                                           const RadiusLevel& open) const {
  const PortalGraph& areas = open.areas(from.stop);
  const auto nodeAt = [&](FinePoint p) {
    return areas.nodeAt(map_->map().geometry().index(p.pixel()));
  };
  const auto isGoal = [&](std::uint32_t node) {
    return goal.point ? node == nodeAt(*goal.point) : areas.classOf(node) == goal.label;
  };
  const auto isForbidden = [&](std::uint16_t label) {
    return label != from.open_area && levels_->keepOut()->forbids(label);
  };
  std::string text;
  const std::uint32_t start = nodeAt(from.starts.places.front().point);
  for (const std::uint16_t label : forbiddenBetween(areas, start, isGoal, isForbidden)) {
    text += text.empty() ? "; in the way: " : ", ";
    text += "forbidden area '" + map_->area_map.areas[label - 1U].name + "'";
  }
  return text;
}

}  // namespace agrid::planning
