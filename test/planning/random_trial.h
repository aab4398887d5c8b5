// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid::test {

/// A map, a robot and two pixels.
struct Trial {
  Scene scene;
  PlannerParams params;
  Pixel start;
  Pixel goal;
};

inline Trial randomTrial(std::mt19937& random) {
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Trial trial;
  MapGeometry geometry{pick(3, 32), pick(3, 24), pick(0, 1) == 0 ? 0.05 : 0.13, {}};
  if (pick(0, 1) == 0) geometry.map_from_image = {{real(-50, 50), real(-50, 50)}, real(-3, 3)};
  trial.scene.grid = randomPlan(random, geometry);
  trial.scene.x_lines = pick(1, std::max(1, geometry.width / 2));
  trial.scene.y_lines = pick(1, std::max(1, geometry.height / 2));
  if (pick(0, 2) == 0) trial.scene.grid_yaw = real(-2, 2);
  if (pick(0, 1) == 0) trial.scene.line_seed = static_cast<unsigned>(random());
  const double radii_px[] = {0, 0.5, 1, 1.4, 1.5, 2, 2.3, 3, 5, 40};  // no gap is wider than 6
  trial.params.robot_radius = radii_px[pick(0, 9)] * geometry.resolution;
  trial.params.clearance = pick(0, 1) == 0 ? Clearance::kCostmap : Clearance::kStrict;
  trial.params.allow_unknown = pick(0, 2) == 0;
  trial.start = {pick(0, geometry.width - 1), pick(0, geometry.height - 1)};
  trial.goal = {pick(0, geometry.width - 1), pick(0, geometry.height - 1)};
  return trial;
}

/// Mostly free ends: random ones are seldom.
inline void preferFree(std::mt19937& random, const SlowFreeSpace& slow, Trial& trial) {
  const MapGeometry& g = trial.scene.grid.geometry;
  std::uniform_int_distribution<std::size_t> any(0, g.pixelCount() - 1);
  for (Pixel* p : {&trial.start, &trial.goal}) {
    for (int i = 0; i < 30 && !slow.isFree(*p); ++i) *p = g.pixel(any(random));
  }
}

/// P15: starts and ends right, and every segment is free.
inline void checkPath(const Trial& trial, const SlowFreeSpace& slow, const Plan& plan) {
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

}  // namespace agrid::test
