// SPDX-License-Identifier: BSD-3-Clause
// How short paths are, and where ends go that may be moved, on random maps against slow oracles.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
#include "planning/random_trial.h"

namespace agrid {
namespace {

using test::BestLength;
using test::Scene;
using test::SlowFreeSpace;
using test::Trial;

/// Paths turn on a lattice of 1/32768 pixel, a bound may take that for granted [px].
constexpr double kLattice = 1e-3;

/// The map cut into areas by some columns, whatever the walls.
void addAreas(std::mt19937& random, Scene& scene) {
  const MapGeometry& g = scene.grid.geometry;
  std::string row;
  char letter = 'A';
  for (int x = 0; x < g.width; ++x) {
    if (random() % 8 == 0 && letter < 'E') ++letter;
    row += random() % 16 == 0 ? ' ' : letter;
  }
  scene.areas.assign(static_cast<std::size_t>(g.height), row);
}

std::vector<Pixel> freePixels(const MapGeometry& geometry, const SlowFreeSpace& slow,
                              const std::function<bool(Pixel)>& wanted) {
  std::vector<Pixel> pixels;
  for (std::size_t i = 0; i < geometry.pixelCount(); ++i) {
    const Pixel p = geometry.pixel(i);
    if (slow.isFree(p) && wanted(p)) pixels.push_back(p);
  }
  return pixels;
}

TEST(PlanQuality, PathsAreNearlyTheShortestAndNoneIsShorterThanItsBound) {
  std::mt19937 random(77);
  int compared = 0;
  double sum = 0;
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = test::randomTrial(random);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    preferFree(random, slow, trial);
    if (trial.start == trial.goal) continue;
    const Plan plan =
        Planner(test::mapOf(trial.scene), trial.params)
            .plan(test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal)));
    if (plan.status != PlanStatus::kSuccess) continue;
    const MapGeometry& geometry = trial.scene.grid.geometry;
    const double best =
        BestLength(slow, geometry).toNearest(trial.start, {trial.goal}) * geometry.resolution;
    EXPECT_LE(plan.length_bound, best + kLattice * geometry.resolution);
    EXPECT_GE(plan.length, best - 1e-9);
    worst = std::max(worst, plan.length / best);
    sum += plan.length / best;
    ++compared;
  }
  ASSERT_GT(compared, 1000);
  EXPECT_LT(sum / compared, 1.0005);
  EXPECT_LT(worst, 1.005);
  RecordProperty("mean", std::to_string(sum / compared));
  RecordProperty("worst", std::to_string(worst));
}

TEST(PlanQuality, P9_OnePlannerAnswersEveryRadiusAsIfItWereTheOnlyOne) {
  std::mt19937 random(78);
  for (int i = 0; i < 300; ++i) {
    Trial trial = test::randomTrial(random);
    const Planner planner(test::mapOf(trial.scene), trial.params);
    for (const double radius_px : {0.0, 2.3, 1.0, 40.0, 1.5, 5.0, 0.0, 2.0, 1.0}) {
      SCOPED_TRACE("trial " + std::to_string(i) + " radius " + std::to_string(radius_px));
      const double radius = radius_px * trial.scene.grid.geometry.resolution;
      const SlowFreeSpace slow(trial.scene, trial.params, radius);
      preferFree(random, slow, trial);
      PlanRequest request =
          test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
      request.robot_radius = radius;
      const Plan plan = planner.plan(request);
      ASSERT_EQ(plan.status == PlanStatus::kSuccess, slow.connects(trial.start, trial.goal));
      if (plan.status == PlanStatus::kSuccess) checkPath(trial, slow, plan);
    }
  }
}

TEST(PlanQuality, P7_AnAreaIsReachedWhereTheNearestPathEndsIfAnyPixelOfItCanBe) {
  std::mt19937 random(79);
  int found = 0;
  double sum = 0;
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = test::randomTrial(random);
    addAreas(random, trial.scene);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    preferFree(random, slow, trial);
    if (!slow.isFree(trial.start)) continue;
    const auto map = test::mapOf(trial.scene);
    const MapGeometry& geometry = trial.scene.grid.geometry;
    const auto label = static_cast<std::uint16_t>(1 + random() % map->area_map.areas.size());
    PlanRequest request = test::requestFrom(trial.scene.at(trial.start), Point2::Zero());
    request.goal = AreaGoal{AreaId{label}, false};
    const Plan plan = Planner(map, trial.params).plan(request);
    const auto inside = freePixels(geometry, slow, [&](Pixel p) {
      return map->area_map.pixel_labels[geometry.index(p)] == label;
    });
    const double best =
        BestLength(slow, geometry).toNearest(trial.start, inside) * geometry.resolution;
    if (inside.empty()) {
      EXPECT_EQ(plan.status, PlanStatus::kGoalInvalid);
    } else if (std::isinf(best)) {
      EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
    } else {
      ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
      const auto end = geometry.pixelAt(plan.path_map.back().position);
      ASSERT_TRUE(end && std::find(inside.begin(), inside.end(), *end) != inside.end());
      for (std::size_t k = 1; k < plan.path_map.size(); ++k) {
        EXPECT_FALSE(slow.touchesBlocked(plan.path_map[k - 1].position, plan.path_map[k].position));
      }
      EXPECT_LE(plan.length_bound, best + kLattice * geometry.resolution);
      worst = std::max(worst, plan.length / best);
      if (best == 0) continue;
      sum += plan.length / best;
      ++found;
    }
  }
  ASSERT_GT(found, 300);
  EXPECT_LT(sum / found, 1.01);
  RecordProperty("mean", std::to_string(sum / found));
  RecordProperty("worst", std::to_string(worst));
}

TEST(PlanQuality, P3_EndsAreMovedWithinTheToleranceAsLittleAsConnectsThem) {
  std::mt19937 random(80);
  int moved = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    const Trial trial = test::randomTrial(random);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    const MapGeometry& geometry = trial.scene.grid.geometry;
    const double reach_px = 0.37 + 0.9 * static_cast<double>(random() % 6);
    const auto shift = [](Pixel a, Pixel b) { return std::hypot(a.x - b.x, a.y - b.y); };
    const auto near = [&](Pixel wanted) {
      if (slow.isFree(wanted)) return std::vector<Pixel>{wanted};
      return freePixels(geometry, slow, [&](Pixel p) { return shift(p, wanted) <= reach_px; });
    };
    PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    request.tolerance = reach_px * geometry.resolution;
    const Plan plan = Planner(test::mapOf(trial.scene), trial.params).plan(request);
    const std::vector<Pixel> starts = near(trial.start);
    const std::vector<Pixel> goals = near(trial.goal);
    double least = std::numeric_limits<double>::infinity();
    for (const Pixel a : starts) {
      for (const Pixel b : goals) {
        const double sum = shift(a, trial.start) + shift(b, trial.goal);
        if (sum < least && slow.connects(a, b)) least = sum;
      }
    }
    if (starts.empty() || goals.empty() || std::isinf(least)) {
      EXPECT_EQ(plan.status, starts.empty()  ? PlanStatus::kStartInvalid
                             : goals.empty() ? PlanStatus::kGoalInvalid
                                             : PlanStatus::kNoRoute);
      continue;
    }
    ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
    const double shifts = (plan.path_map.front().position - trial.scene.at(trial.start)).norm() +
                          (plan.path_map.back().position - trial.scene.at(trial.goal)).norm();
    EXPECT_NEAR(shifts, least * geometry.resolution, 1e-9);
    EXPECT_EQ(plan.start_moved, !slow.isFree(trial.start));
    EXPECT_EQ(plan.goal_moved, !slow.isFree(trial.goal));
    moved += plan.start_moved || plan.goal_moved ? 1 : 0;
  }
  EXPECT_GT(moved, 200);
}

}  // namespace
}  // namespace agrid
