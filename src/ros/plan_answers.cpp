// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan_answers.h"

#include <algorithm>
#include <cmath>

#include "agrid/pipeline.h"
#include "ros/request_error.h"
#include "ros/text.h"
#include "ros/time_limit.h"
#include "ros/way_to_things.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

/// The same ground, where nothing is waited for beyond the limit. `frames` must outlive it.
Ground limited(const Ground& ground, const Frames& frames) {
  return {ground.snapshot, frames, ground.cancelled, ground.waited};
}

double timeoutParameter(const Ground& ground) {
  return ground.snapshot.parameters->planner.timeout;
}

/// A number of a request where 0 means the parameter.
std::optional<double> unlessZero(double value) {
  return value == 0 ? std::nullopt : std::optional<double>(value);
}

agrid::PlanPoint robotPoint(const Ground& ground) {
  const agrid::Pose2 pose = ground.frames.robotPose(ground.snapshot.parameters->node.base_frame);
  return {pose.position, pose.yaw};
}

/// Where a named start lies: an area's anchor, an object's centre.
agrid::PlanPoint namedStart(const Ground& ground, const std::string& name) {
  const std::vector<agrid::Thing> things = findThings(*ground.snapshot.map, name, {}).things;
  if (things.size() > 1) {
    throw RequestError(Status::START_INVALID, "'" + printable(name) + "' means " +
                                                  std::to_string(things.size()) +
                                                  " things; give one of their ids or a start pose");
  }
  return {positionOf(things.front()), std::nullopt};
}

agrid::PlanPoint startOf(const Ground& ground, const agrid_map::PlanAreas::Request& request) {
  if (request.start_from_robot) return robotPoint(ground);
  if (!request.start.empty()) return namedStart(ground, request.start);
  return ground.frames.planPoint(request.start_pose);
}

void fillPath(agrid_map::PlanPath::Response& response, const Ground& ground,
              const agrid::Plan& plan) {
  response.route = toMsg(plan.route, ground.snapshot.map->area_map);
  response.cells = plan.cells;
  response.path = pathToMsg(plan.path_map, ground.snapshot.stamp.header);
  response.length = plan.length;
  response.length_bound = plan.length_bound;
  response.clearance = plan.clearance;
  response.start_moved = plan.start_moved;
  response.goal_moved = plan.goal_moved;
}

agrid::Plan planPathTo(const Ground& ground, const agrid_map::PlanPath::Request& request,
                       agrid::PlanRequest wanted, const TimeLimit& limit) {
  wanted.start =
      request.start_from_robot ? robotPoint(ground) : ground.frames.planPoint(request.start);
  if (request.goal_name.empty()) {
    wanted.goal = ground.frames.planPoint(request.goal);
    wanted.timeout = limit.left();
    return ground.snapshot.planner->plan(wanted);
  }
  const agrid::FoundThings found =
      findThings(*ground.snapshot.map, request.goal_name, {false, true});
  const WayFinder ways{*ground.snapshot.planner, limit, ground.snapshot.map.get()};
  agrid::Plan plan = ways.planToNearest(found.things, wanted, request.goal_at_anchor);
  plan.message = withRemark(found, plan.message);
  return plan;
}

/// The same snapshot with more doors closed, for one request.
Snapshot withClosedDoors(const Snapshot& snapshot, const std::vector<std::uint32_t>& ids) {
  agrid::Knowledge known = snapshot.map->knowledge;
  for (const std::uint32_t id : ids) {
    const auto door = std::find_if(known.doors.begin(), known.doors.end(),
                                   [&](const auto& tag) { return tag.id == agrid::DoorId{id}; });
    if (door == known.doors.end()) {
      throw RequestError(Status::UNKNOWN_NAME,
                         "closed_doors: no door has the id " + std::to_string(id));
    }
    door->state = agrid::DoorState::kClosed;
  }
  Snapshot closed = snapshot;
  closed.map = std::make_shared<const agrid::SemanticMap>(agrid::retag(*snapshot.map, known));
  closed.planner = std::make_shared<const agrid::Planner>(closed.map, *snapshot.planner);
  return closed;
}

}  // namespace

agrid_map::PlanAreas::Response answerPlanAreas(const Ground& ground,
                                               const agrid_map::PlanAreas::Request& request) {
  const Snapshot& snapshot = ground.snapshot;
  const TimeLimit limit(0, timeoutParameter(ground), ground.waited);
  limit.requireTime();
  const Frames frames = ground.frames.until(limit.deadline());
  agrid::PlanRequest wanted;
  wanted.robot_radius = unlessZero(request.robot_radius);
  wanted.cancelled = &ground.cancelled;
  wanted.start = startOf(limited(ground, frames), request);
  agrid::RouteList list;
  if (request.goal.empty()) {
    wanted.goal = frames.planPoint(request.goal_pose);
    wanted.timeout = limit.left();
    list = snapshot.planner->routes(wanted, request.max_routes);
  } else {
    const agrid::FoundThings found = findThings(*snapshot.map, request.goal, {false, true});
    const WayFinder ways{*snapshot.planner, limit, snapshot.map.get()};
    list = ways.routesToNearest(found.things, wanted, request.max_routes);
    list.message = withRemark(found, list.message);
  }
  agrid_map::PlanAreas::Response response;
  response.status = statusOf(list.status, list.message);
  for (const agrid::Route& route : list.routes) {
    response.routes.push_back(toMsg(route, snapshot.map->area_map));
  }
  return response;
}

agrid_map::PlanPath::Response answerPlanPath(const Ground& ground,
                                             const agrid_map::PlanPath::Request& request) {
  if (!request.closed_doors.empty()) {
    const Snapshot closed = withClosedDoors(ground.snapshot, request.closed_doors);
    agrid_map::PlanPath::Request rest = request;
    rest.closed_doors.clear();
    return answerPlanPath({closed, ground.frames, ground.cancelled, ground.waited}, rest);
  }
  const TimeLimit limit(request.timeout, timeoutParameter(ground), ground.waited);
  limit.requireTime();
  const Frames frames = ground.frames.until(limit.deadline());
  agrid::PlanRequest wanted;
  wanted.tolerance = request.tolerance;
  wanted.robot_radius = unlessZero(request.robot_radius);
  wanted.turning_radius = unlessZero(request.turning_radius);
  if (!request.planner.empty()) wanted.planner = request.planner.substr(0, 256);
  wanted.seed = request.seed;
  wanted.cancelled = &ground.cancelled;
  const agrid::Plan plan = planPathTo(limited(ground, frames), request, wanted, limit);
  agrid_map::PlanPath::Response response;
  response.status = statusOf(plan.status, plan.message);
  response.planning_time = plan.planning_time;
  response.map_id = ground.snapshot.map->map().digest();
  if (plan.status == agrid::PlanStatus::kSuccess) fillPath(response, ground, plan);
  return response;
}

nav_msgs::GetPlan::Response answerMakePlan(const Ground& ground,
                                           const nav_msgs::GetPlan::Request& request) {
  const TimeLimit limit(0, timeoutParameter(ground), ground.waited);
  limit.requireTime();
  const Frames frames = ground.frames.until(limit.deadline());
  agrid::PlanRequest wanted;
  wanted.start = frames.planPoint(request.start);
  wanted.goal = frames.planPoint(request.goal);
  wanted.timeout = limit.left();
  wanted.tolerance = static_cast<double>(request.tolerance);
  wanted.cancelled = &ground.cancelled;
  const agrid::Plan plan = ground.snapshot.planner->plan(wanted);
  if (plan.status != agrid::PlanStatus::kSuccess) {
    const agrid_map::Status status = statusOf(plan.status, plan.message);
    throw RequestError(status.code, status.message);
  }
  nav_msgs::GetPlan::Response response;
  response.plan = pathToMsg(plan.path_map, ground.snapshot.stamp.header);
  return response;
}

void remarkChange(agrid_map::Status& status, const Snapshot& used, const Snapshot* newest) {
  if (newest == &used) return;
  // edits share the metric map, a rebuild brings its own
  const bool same_map = newest && newest->map->structure.map == used.map->structure.map;
  status.message += status.message.empty() ? "" : "; ";
  status.message +=
      same_map ? "what is known has changed meanwhile" : "a newer map has been built meanwhile";
}

}  // namespace agrid_map_ros
