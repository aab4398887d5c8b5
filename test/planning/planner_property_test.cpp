// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using test::Scene;
using test::SlowFreeSpace;

struct Trial {
  Scene scene;
  PlannerParams params;
  Pixel start;
  Pixel goal;
};

Trial randomTrial(std::mt19937& random) {
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Trial trial;
  MapGeometry geometry{pick(3, 32), pick(3, 24), pick(0, 1) == 0 ? 0.05 : 0.13, {}};
  if (pick(0, 1) == 0) geometry.map_from_image = {{real(-50, 50), real(-50, 50)}, real(-3, 3)};
  trial.scene.grid = test::randomPlan(random, geometry);
  trial.scene.x_lines = pick(1, std::max(1, geometry.width / 2));
  trial.scene.y_lines = pick(1, std::max(1, geometry.height / 2));
  if (pick(0, 2) == 0) trial.scene.grid_yaw = real(-2, 2);
  const double radii_px[] = {0, 0.5, 1, 1.4, 1.5, 2, 2.3, 3, 5};
  trial.params.robot_radius = radii_px[pick(0, 8)] * geometry.resolution;
  trial.params.clearance = pick(0, 1) == 0 ? Clearance::kCostmap : Clearance::kStrict;
  trial.params.allow_unknown = pick(0, 2) == 0;
  trial.start = {pick(0, geometry.width - 1), pick(0, geometry.height - 1)};
  trial.goal = {pick(0, geometry.width - 1), pick(0, geometry.height - 1)};
  return trial;
}

/// Mostly free ends: random ones are seldom.
void preferFree(std::mt19937& random, const SlowFreeSpace& slow, Trial& trial) {
  const MapGeometry& g = trial.scene.grid.geometry;
  std::uniform_int_distribution<std::size_t> any(0, g.pixelCount() - 1);
  for (Pixel* p : {&trial.start, &trial.goal}) {
    for (int i = 0; i < 30 && !slow.isFree(*p); ++i) *p = g.pixel(any(random));
  }
}

/// P15: starts and ends right, and every segment is free.
void checkPath(const Trial& trial, const SlowFreeSpace& slow, const Plan& plan) {
  ASSERT_FALSE(plan.path_map.empty());
  EXPECT_LT((plan.path_map.front().position - trial.scene.at(trial.start)).norm(), 1e-9);
  EXPECT_LT((plan.path_map.back().position - trial.scene.at(trial.goal)).norm(), 1e-9);
  double length = 0;
  for (std::size_t i = 1; i < plan.path_map.size(); ++i) {
    const Point2& a = plan.path_map[i - 1].position;
    const Point2& b = plan.path_map[i].position;
    EXPECT_FALSE(slow.touchesBlocked(a, b)) << "segment " << i;
    EXPECT_NEAR(plan.path_map[i - 1].yaw, std::atan2(b.y() - a.y(), b.x() - a.x()), 1e-9);
    length += (b - a).norm();
  }
  EXPECT_NEAR(plan.length, length, 1e-9);
  EXPECT_LE(plan.length_bound, plan.length);
  const double straight = (trial.scene.at(trial.start) - trial.scene.at(trial.goal)).norm();
  EXPECT_GE(plan.length_bound, straight - 1e-9);
}

TEST(Planner, P15_FindsAFreePathExactlyWhereAFloodFillConnects) {
  std::mt19937 random(20240607);
  int found = 0;
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = randomTrial(random);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    preferFree(random, slow, trial);
    const Planner planner(test::mapOf(trial.scene), trial.params);
    const PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    const Plan plan = planner.plan(request);
    EXPECT_EQ(planner.routes(request, 1).status, plan.status);
    if (!slow.isFree(trial.start)) {
      EXPECT_EQ(plan.status, PlanStatus::kStartInvalid);
    } else if (!slow.isFree(trial.goal)) {
      EXPECT_EQ(plan.status, PlanStatus::kGoalInvalid);
    } else if (!slow.connects(trial.start, trial.goal)) {
      EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
      ++apart;
    } else {
      ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
      checkPath(trial, slow, plan);
      ++found;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(apart, 100);
}

TEST(Planner, P18_TheSameRequestGivesTheSamePath) {
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    Trial trial = randomTrial(random);
    preferFree(random, {trial.scene, trial.params, trial.params.robot_radius}, trial);
    const auto map = test::mapOf(trial.scene);
    PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    request.seed = 9;
    if (i % 2 == 0) request.planner = "RRTConnect";
    const Plan a = Planner(map, trial.params).plan(request);
    const Plan b = Planner(map, trial.params).plan(request);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.path_map.size(), b.path_map.size());
    for (std::size_t k = 0; k < a.path_map.size(); ++k) {
      EXPECT_EQ(a.path_map[k].position, b.path_map[k].position);
    }
  }
}

}  // namespace
}  // namespace agrid
