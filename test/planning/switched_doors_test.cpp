// SPDX-License-Identifier: BSD-3-Clause
// Doors that are opened and closed one after another, against planners made from scratch.
#include <random>

#include <gtest/gtest.h>

#include "planning/switching.h"

namespace agrid {
namespace {

using test::levelOf;
using test::randomSwitching;
using test::SlowFreeSpace;
using test::Switching;
using test::Trial;

/// Closed doors as obstacles of the map, for the slow oracle.
test::Scene withDoorsInTheMap(const test::Scene& scene, const SemanticMap& map,
                              bool allow_unknown) {
  test::Scene drawn = scene;
  const planning::Obstacles obstacles(map, allow_unknown);
  for (std::size_t i = 0; i < drawn.grid.values.size(); ++i) {
    if (obstacles.at(i)) drawn.grid.values[i] = 100;
  }
  return drawn;
}

/// The same pixels, regions, portals and components, whatever their numbers; roads as long.
void expectSameRegions(const MapGeometry& g, const planning::RadiusLevel& a,
                       const planning::RadiusLevel& b) {
  std::map<std::uint32_t, std::uint32_t> region_of;
  std::map<std::uint32_t, std::uint32_t> component_of;
  for (std::size_t i = 0; i < g.pixelCount(); ++i) {
    ASSERT_EQ(a.free.squaredDistance(g.pixel(i)), b.free.squaredDistance(g.pixel(i))) << i;
    const std::uint32_t in_a = a.roadmap.regions().nodeAt(i);
    const std::uint32_t in_b = b.roadmap.regions().nodeAt(i);
    ASSERT_EQ(in_a == planning::kNoNode, in_b == planning::kNoNode) << i;
    if (in_a == planning::kNoNode) continue;
    ASSERT_EQ(region_of.emplace(in_a, in_b).first->second, in_b);
    ASSERT_EQ(
        component_of
            .emplace(a.roadmap.regions().componentOf(in_a), b.roadmap.regions().componentOf(in_b))
            .first->second,
        b.roadmap.regions().componentOf(in_b));
    ASSERT_EQ(a.regionLabels().labelOf(in_a), b.regionLabels().labelOf(in_b));
  }
  for (const auto& [in_a, in_b] : region_of) {
    ASSERT_EQ(a.roadmap.regions().portalsOf(in_a).size(),
              b.roadmap.regions().portalsOf(in_b).size());
    ASSERT_EQ(a.roadmap.roads(in_a).points().size(), b.roadmap.roads(in_b).points().size());
    double sum_a = 0;
    double sum_b = 0;
    for (const auto measure : {planning::Measure::kPath, planning::Measure::kLeast}) {
      for (std::size_t p = 0; p < a.roadmap.regions().portalsOf(in_a).size(); ++p) {
        const std::size_t count =
            a.roadmap.roads(in_a).points().size() + a.roadmap.roads(in_a).portalCount();
        for (std::size_t n = 0; n < count; ++n) {
          const float in_first = a.roadmap.roads(in_a).lengthsTo(measure, p)[n];
          const float in_second = b.roadmap.roads(in_b).lengthsTo(measure, p)[n];
          sum_a += in_first < planning::kUnreachable ? in_first : 0.0F;
          sum_b += in_second < planning::kUnreachable ? in_second : 0.0F;
        }
      }
    }
    ASSERT_NEAR(sum_a, sum_b, 1e-3 * (1 + sum_a));
  }
}

TEST(SwitchedDoors, WhatIsPreparedIsAsIfFromScratch) {
  std::mt19937 random(4711);
  for (int i = 0; i < 400; ++i) {
    Switching s = randomSwitching(random);
    const MapGeometry& g = s.trial.scene.grid.geometry;
    for (int k = 0; k < 5; ++k) {
      SCOPED_TRACE("trial " + std::to_string(i) + ", step " + std::to_string(k));
      const Planner fresh(s.map, s.trial.params);
      for (const double radius : {s.trial.params.robot_radius, 1.2 * g.resolution}) {
        if (k == 2 && radius != s.trial.params.robot_radius) continue;  // two steps at once
        expectSameRegions(g, *levelOf(*s.planner, radius), *levelOf(fresh, radius));
        if (HasFailure()) return;
      }
      s.switchSome(random);
    }
  }
}

TEST(SwitchedDoors, PathsAreFoundExactlyWhereAFloodFillConnects) {
  std::mt19937 random(815);
  int found = 0;
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    Switching s = randomSwitching(random);
    for (int k = 0; k < 6; ++k) {
      SCOPED_TRACE("trial " + std::to_string(i) + ", step " + std::to_string(k));
      Trial drawn = s.trial;
      drawn.scene = withDoorsInTheMap(s.trial.scene, *s.map, s.trial.params.allow_unknown);
      const SlowFreeSpace slow(drawn.scene, drawn.params, drawn.params.robot_radius);
      test::preferFree(random, slow, drawn);
      const PlanRequest request =
          test::requestFrom(drawn.scene.at(drawn.start), drawn.scene.at(drawn.goal));
      const Plan plan = s.planner->plan(request);
      const Planner fresh(s.map, s.trial.params);
      const Plan other = fresh.plan(request);
      ASSERT_EQ(plan.status, other.status) << plan.message << " / " << other.message;
      EXPECT_EQ(plan.message, other.message);
      EXPECT_EQ(s.planner->routes(request, 2).routes.size(),
                fresh.routes(request, 2).routes.size());
      if (slow.isFree(drawn.start) && slow.isFree(drawn.goal)) {
        ASSERT_EQ(plan.status == PlanStatus::kSuccess, slow.connects(drawn.start, drawn.goal));
        ++(plan.status == PlanStatus::kSuccess ? found : apart);
      }
      if (plan.status == PlanStatus::kSuccess) {
        test::checkPath(drawn, slow, plan);
        EXPECT_NEAR(plan.length, other.length, 1e-3 * other.length);
        EXPECT_LE(plan.length_bound, other.length + 1e-9);
        EXPECT_LE(other.length_bound, plan.length + 1e-9);
      }
      if (HasFailure()) return;
      s.switchSome(random);
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(apart, 200);
}

}  // namespace
}  // namespace agrid
