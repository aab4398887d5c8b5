// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using test::Scene;

/// A wall with a gap of so many pixels; straight across the map, or along its diagonal.
Scene wallWithGap(int gap, bool diagonal) {
  constexpr int side = 41;
  Scene scene;
  scene.grid.geometry = {side, side, 0.05, {{-3, 7}, 0.3}};
  scene.grid.values.assign(side * side, 0);
  scene.x_lines = 7;
  scene.y_lines = 5;
  for (int i = 0; i < side; ++i) {
    if (i >= 20 - gap / 2 && i < 20 - gap / 2 + gap) continue;
    const auto block = [&](int x, int y) {
      if (scene.grid.geometry.contains({x, y})) {
        scene.grid.values[scene.grid.geometry.index({x, y})] = 100;
      }
    };
    block(diagonal ? side - 1 - i : 20, i);
    if (diagonal) block(side - 2 - i, i);
  }
  return scene;
}

PlanStatus statusThrough(const Scene& scene, const PlannerParams& params) {
  const PlanRequest request = test::requestFrom(scene.at(8, 8), scene.at(32, 32));
  return Planner(test::mapOf(scene), params).plan(request).status;
}

TEST(PassageWidth, OnePixelDecidesAtAStraightGap) {
  // The middle pixel of 2 r + 1 pixels between two obstacles is r + 1 from both: farther than r.
  for (const int r : {0, 1, 2, 3, 4}) {
    PlannerParams params;
    params.robot_radius = r * 0.05;
    EXPECT_EQ(statusThrough(wallWithGap(2 * r + 1, false), params), PlanStatus::kSuccess) << r;
    if (r == 0) continue;
    EXPECT_EQ(statusThrough(wallWithGap(2 * r, false), params), PlanStatus::kNoRoute) << r;
  }
}

TEST(PassageWidth, StrictClearanceNeedsTwoPixelsMore) {
  // From the middle pixel's square to an obstacle's square there is one pixel less at each side.
  for (const int r : {0, 1, 2, 3, 4}) {
    PlannerParams params;
    params.robot_radius = r * 0.05;
    params.clearance = Clearance::kStrict;
    EXPECT_EQ(statusThrough(wallWithGap(2 * r + 3, false), params), PlanStatus::kSuccess) << r;
    EXPECT_EQ(statusThrough(wallWithGap(2 * r + 2, false), params), PlanStatus::kNoRoute) << r;
  }
}

TEST(PassageWidth, OnePixelDecidesAtADiagonalGap) {
  for (const Clearance clearance : {Clearance::kCostmap, Clearance::kStrict}) {
    for (const int r : {0, 1, 2, 3}) {
      PlannerParams params;
      params.robot_radius = r * 0.05;
      params.clearance = clearance;
      int first = 0;
      for (int gap = 1; gap < 16; ++gap) {
        const Scene scene = wallWithGap(gap, true);
        const test::SlowFreeSpace slow(scene, params, params.robot_radius);
        const bool open = slow.connects({8, 8}, {32, 32});
        EXPECT_EQ(statusThrough(scene, params), open ? PlanStatus::kSuccess : PlanStatus::kNoRoute)
            << "radius " << r << " gap " << gap;
        if (open && first == 0) first = gap;
      }
      EXPECT_GT(first, r);
      EXPECT_LT(first, 16);
    }
  }
}

}  // namespace
}  // namespace agrid
