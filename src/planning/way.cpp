// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/way.h"

namespace agrid {

std::vector<Point2> wayBetween(const Planner& planner, const Point2& from_map,
                               const Point2& to_map) {
  PlanRequest request;
  request.start.position_map = from_map;
  PlanPoint goal;
  goal.position_map = to_map;
  request.goal = goal;
  request.robot_radius = planner.circleRadius();
  request.turning_radius = 0;
  request.planner = "AGrid";
  const Plan plan = planner.plan(request);
  std::vector<Point2> corners;
  if (plan.status != PlanStatus::kSuccess) return corners;
  for (const Pose2& pose : plan.path_map) corners.push_back(pose.position);
  return corners;
}

}  // namespace agrid
