// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "planning/ompl/shorten.h"
#include "planning/ompl/turning_path.h"
#include "planning/planner_core.h"

namespace agrid::planning {
namespace {

/// An asked heading is decided at once; of those that may be chosen, others may fit.
void requireFits(const SweptRobot& robot, const Point2& position_map,
                 const std::optional<double>& yaw, const Refusal& refusal) {
  if (yaw && !robot.isFree(Pose2{position_map, *yaw})) throw refusal;
}

/// The same request for a circle around the whole robot, which may start and end near by.
PlanRequest around(const PlanRequest& request, const TurningQuery& wanted, double radius) {
  PlanRequest result = request;
  result.start.position_map = wanted.lead_map.front();
  PlanPoint goal;
  goal.position_map = wanted.lead_map.back();
  result.goal = goal;
  result.tolerance = 2 * radius;
  return result;
}

/// Where the outline does not pass as the circle inside does, the circle around it shows a way;
/// empty if it doesn't.
std::vector<Point2> detour(const PlannerCore& core, const TurningQuery& wanted,
                           const PlanRequest& request, const Query& wide, const StopCheck& stop) {
  std::vector<Point2> corners{wanted.lead_map.front()};
  try {
    const Task task = core.taskOf(around(request, wanted, wide.robot_radius), wide, stop);
    for (const FinePoint p : core.pathOf(task, wide, request.seed, stop).corners) {
      corners.push_back(mapPoint(core.map().map().geometry(), p));
    }
  } catch (const Refusal&) {
    return {};
  }
  corners.push_back(wanted.lead_map.back());
  return corners;
}

}  // namespace

std::shared_ptr<const SweptRobot> PlannerCore::robot(double radius, const Polygon& footprint,
                                                     const StopCheck& stop) const {
  const FreeSpace& free = levels_->get(radius, kNoneEntered, stop)->free;
  return robotIn(free, footprint);
}

std::shared_ptr<const SweptRobot> PlannerCore::robotIn(const FreeSpace& free,
                                                       const Polygon& footprint) const {
  if (footprint.empty()) return std::make_shared<const SweptRobot>(free);
  return std::make_shared<const SweptRobot>(free, obstacles_, footprint);
}

PlannerCore::Path PlannerCore::turningPathOf(const Task& task, const PlanRequest& request,
                                             const Query& query, const Path& lead,
                                             const StopCheck& stop) const {
  if (lead.corners.size() < 2 && !request.start.yaw && !task.goal_yaw) return lead;
  const MapGeometry& geometry = map_->map().geometry();
  const auto robot = robotIn(task.level->free, query.footprint);
  TurningQuery wanted;
  wanted.turning_radius = query.turning_radius;
  wanted.motion = query.motion;
  for (const FinePoint p : lead.corners) wanted.lead_map.push_back(mapPoint(geometry, p));
  wanted.start_yaw = request.start.yaw;
  wanted.goal_yaw = task.goal_yaw;
  wanted.seed = request.seed;
  requireFits(*robot, wanted.lead_map.front(), wanted.start_yaw,
              {PlanStatus::kStartInvalid, "the robot does not fit at the start with its heading"});
  requireFits(*robot, wanted.lead_map.back(), wanted.goal_yaw,
              {PlanStatus::kGoalInvalid, "the robot does not fit at the goal with its heading"});
  Query wide = query;
  wide.robot_radius = robot->outerRadius();
  if (!query.footprint.empty()) {
    wanted.detour_map = [&] { return detour(*this, wanted, request, wide, stop); };
  }
  Path path;
  path.length_bound_px = lead.length_bound_px;
  for (const Pose2& pose : planTurning(robot, wanted, stop)) {
    path.corners.push_back(finePoint(pixelCoordinates(geometry, pose.position)));
    path.yaws.push_back(pose.yaw);
  }
  if (path.corners.empty()) {
    throw Refusal{PlanStatus::kTimeout,
                  "no path was found in time for the robot's turning radius or footprint, though "
                  "there is one for a circle inside it that turns on the spot"};
  }
  if (!passesOmplCheck(task.level->free, path.corners)) {
    throw std::logic_error("Planner: the check of a robot's curve does not hold for its poses");
  }
  return path;
}

}  // namespace agrid::planning
