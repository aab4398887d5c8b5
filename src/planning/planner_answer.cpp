// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "planning/planner_core.h"
#include "planning/tighten.h"

namespace agrid::planning {
namespace {

std::vector<Pose2> posesOf(const MapGeometry& geometry, const std::vector<FinePoint>& path) {
  std::vector<Pose2> poses;
  for (const FinePoint p : path) poses.push_back({mapPoint(geometry, p), 0});
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Point2 along = poses[i + 1].position - poses[i].position;
    poses[i].yaw = std::atan2(along.y(), along.x());
  }
  if (poses.size() > 1) poses.back().yaw = poses[poses.size() - 2].yaw;
  return poses;
}

std::vector<Pose2> posesOf(const MapGeometry& geometry, const PlannerCore::Path& path) {
  std::vector<Pose2> poses = posesOf(geometry, path.corners);
  for (std::size_t i = 0; i < path.yaws.size(); ++i) poses[i].yaw = path.yaws[i];
  return poses;
}

}  // namespace

Plan PlannerCore::planOf(const Task& task, const PlanRequest& request, const Path& found) const {
  const std::vector<FinePoint>& path = found.corners;
  const MapGeometry& geometry = map_->map().geometry();
  const std::vector<Pixel> pixels = crossedPixels(path);
  Plan plan;
  plan.path_map = posesOf(geometry, found);
  if (request.start.yaw) plan.path_map.front().yaw = *request.start.yaw;
  if (task.goal_yaw) plan.path_map.back().yaw = *task.goal_yaw;
  plan.cells = cells_.cellsAlong(pixels);
  plan.length = lengthPx(path) * geometry.resolution;
  // A sum of rounded lengths may fall below a bound that is met exactly.
  plan.length_bound = std::min(found.length_bound_px * geometry.resolution, plan.length);
  plan.route = crossedAreas(*map_, pixels);
  plan.route.length = plan.length;
  plan.clearance = pathClearancePx(task.level->free, obstacles_, path) * geometry.resolution;
  plan.start_moved = task.start.moved;
  plan.goal_moved = task.goal_moved;
  return plan;
}

}  // namespace agrid::planning
