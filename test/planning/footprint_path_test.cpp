// SPDX-License-Identifier: BSD-3-Clause
// Plans for a robot with a footprint; see footprint_test.cpp for the outline itself.
#include <gtest/gtest.h>

#include "planning/drive_oracle.h"

namespace agrid {
namespace {

using test::driven;
using test::fill;
using test::hall;
using test::halls;
using test::kPi;
using test::request;
using test::Scene;
using test::turned;

PlannerParams longRobot() {
  PlannerParams params;
  params.footprint = {{0.6, 0.2}, {-0.6, 0.2}, {-0.6, -0.2}, {0.6, -0.2}};
  params.timeout = 30;
  return params;
}

/// Every pixel that the outline touches is free, at every pose; on the spot or straight ahead.
void expectFits(const Scene& scene, const PlannerParams& params, const Plan& plan) {
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  const MapGeometry& g = scene.grid.geometry;
  for (std::size_t k = 0; k < plan.path_map.size(); ++k) {
    const Pose2 pose = inverse(g.map_from_image) * plan.path_map[k];
    for (double u = -0.6; u <= 0.6001; u += 0.02) {
      for (double v = -0.2; v <= 0.2001; v += 0.02) {
        const Point2 p = pose * Point2(u, v) / g.resolution;
        const Pixel pixel{static_cast<int>(p.x()), static_cast<int>(p.y())};
        ASSERT_TRUE(g.contains(pixel));
        ASSERT_EQ(scene.grid.values[g.index(pixel)], 0);
      }
    }
    if (k == 0) continue;
    const double way = (plan.path_map[k].position - plan.path_map[k - 1].position).norm();
    EXPECT_NEAR(std::abs(driven(plan.path_map[k - 1], plan.path_map[k])), way, 1e-4);
    EXPECT_TRUE(params.turning_radius > 0 || way < 1e-4 ||
                turned(plan.path_map[k - 1], plan.path_map[k]) < 1e-6);
  }
}

TEST(FootprintPath, FitsThroughAPassageAlongOneHeadingOnly) {
  std::vector<std::string> rows = hall(80, 60);
  fill(rows, 35, 45, 0, 27);
  fill(rows, 35, 45, 33, 60);  // 0.6 m wide, 1 m long; the robot is 1.2 m by 0.4 m
  const Scene scene = halls(rows);
  for (const double radius : {0.0, 0.5}) {
    PlannerParams params = longRobot();
    params.turning_radius = radius;
    const Planner planner(test::mapOf(scene), params);
    const Plan plan = planner.plan(request(scene, {18, 12}, kPi / 2, {62, 48}, kPi / 2));
    expectFits(scene, params, plan);
  }
  // A circle around the robot doesn't fit, and so far the passage would be closed.
  PlanRequest circle = request(scene, {18, 12}, 0, {62, 48}, 0);
  circle.robot_radius = 0.64;
  EXPECT_EQ(Planner(test::mapOf(scene), longRobot()).plan(circle).status, PlanStatus::kNoRoute);
}

TEST(FootprintPath, TakesADetourWhereOnlyTheCircleInsideFits) {
  std::vector<std::string> rows = hall(90, 120);
  fill(rows, 40, 44, 1, 28);
  fill(rows, 40, 44, 32, 95);  // the short way is 0.4 m wide, the long one 2.4 m
  const Scene scene = halls(rows);
  PlannerParams params = longRobot();
  params.turning_radius = 0.5;
  const Planner planner(test::mapOf(scene), params);
  const Plan plan = planner.plan(request(scene, {20, 90}, 0, {65, 90}, 0));
  expectFits(scene, params, plan);
  EXPECT_GT(plan.length, 2 * plan.length_bound);
  EXPECT_LT(plan.length, 4.5 * plan.length_bound);
}

TEST(FootprintPath, TooWideForThePassageIsNoRouteOrOutOfTime) {
  std::vector<std::string> rows = hall(80, 60);
  fill(rows, 35, 45, 0, 28);
  fill(rows, 35, 45, 32, 60);  // 0.4 m: every pixel of the robot's outline must be free
  const Scene scene = halls(rows);
  PlannerParams params = longRobot();
  params.timeout = 0.2;
  const Planner planner(test::mapOf(scene), params);
  EXPECT_EQ(planner.plan(request(scene, {18, 12}, 0, {62, 48}, 0)).status, PlanStatus::kTimeout);
  fill(rows, 35, 45, 30, 60);
  const Planner narrower(test::mapOf(halls(rows)), params);
  EXPECT_EQ(narrower.plan(request(scene, {18, 12}, 0, {62, 48}, 0)).status, PlanStatus::kNoRoute);
}

TEST(FootprintPath, P3_AHeadingThatDoesNotFitIsAnInvalidStartOrGoal) {
  std::vector<std::string> rows = hall(80, 60);
  fill(rows, 0, 30, 0, 27);
  fill(rows, 0, 30, 33, 60);  // a bay of 0.6 m
  const Scene scene = halls(rows);
  const Planner planner(test::mapOf(scene), longRobot());
  const Point2 bay(15, 29.5);
  const Point2 wide(60, 30);
  EXPECT_EQ(planner.plan(request(scene, bay, kPi / 2, wide, 0)).status, PlanStatus::kStartInvalid);
  EXPECT_EQ(planner.plan(request(scene, wide, 0, bay, kPi / 2)).status, PlanStatus::kGoalInvalid);
  expectFits(scene, longRobot(), planner.plan(request(scene, bay, 0, wide, kPi / 2)));
  expectFits(scene, longRobot(), planner.plan(request(scene, wide, 0, bay, kPi)));
}

}  // namespace
}  // namespace agrid
