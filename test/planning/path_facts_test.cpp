// SPDX-License-Identifier: BSD-3-Clause
#include "planning/path_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid::planning {
namespace {

FinePoint at(double x, double y) { return finePoint({x, y}); }

TEST(CrossedPixels, AreInOrderAndWithoutThoseThatAreOnlyTouched) {
  const auto pixels = crossedPixels({at(0, 0), at(2, 2), at(2, 0)});
  const std::vector<Pixel> expected{{0, 0}, {1, 1}, {2, 2}, {2, 1}, {2, 0}};
  EXPECT_TRUE(pixels == expected);
}

TEST(CrossedPixels, HoldEveryPointOfThePath) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0, 30);
  for (int trial = 0; trial < 300; ++trial) {
    const FinePoint a = at(value(random), value(random));
    const FinePoint b = at(value(random), value(random));
    const auto pixels = crossedPixels({a, b});
    EXPECT_TRUE(pixels.front() == a.pixel());
    EXPECT_TRUE(pixels.back() == b.pixel());
    std::size_t i = 0;
    for (int k = 0; k <= 1000; ++k) {
      const Point2 p = coordinates(a) + (coordinates(b) - coordinates(a)) * k / 1000;
      const Pixel pixel = finePoint(p).pixel();
      const Point2 inside = p - Point2(pixel.x, pixel.y);
      if (inside.cwiseAbs().maxCoeff() > 0.499) continue;  // rounding may change the pixel
      while (i < pixels.size() && pixels[i] != pixel) ++i;
      ASSERT_LT(i, pixels.size()) << "trial " << trial;
    }
  }
}

/// Distance from a densely sampled path to the nearest obstacle's square.
double sampledClearance(const test::Scene& scene, const Obstacles& obstacles,
                        const std::vector<FinePoint>& path) {
  const MapGeometry& g = scene.grid.geometry;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 1; s < path.size(); ++s) {
    for (int k = 0; k <= 400; ++k) {
      const Point2 a = coordinates(path[s - 1]);
      const Point2 p = a + (coordinates(path[s]) - a) * k / 400;
      for (std::size_t i = 0; i < g.pixelCount(); ++i) {
        if (!obstacles.at(i)) continue;
        const double dx = std::max(std::abs(p.x() - g.pixel(i).x) - 0.5, 0.0);
        const double dy = std::max(std::abs(p.y() - g.pixel(i).y) - 0.5, 0.0);
        least = std::min(least, std::hypot(dx, dy));
      }
    }
  }
  return least;
}

TEST(PathClearance, IsThatOfADenselySampledPath) {
  std::mt19937 random(9);
  int checked = 0;
  for (int trial = 0; trial < 400; ++trial) {
    test::Scene scene;
    scene.grid = test::randomPlan(random, {24, 18, 1, {}});
    const auto map = test::mapOf(scene);
    const Obstacles obstacles(*map, false);
    for (const Clearance clearance : {Clearance::kCostmap, Clearance::kStrict}) {
      const FreeSpace free(scene.grid.geometry,
                           std::make_shared<const planning::SquaredDistances>(
                               obstacleDistances(scene.grid.geometry, obstacles, clearance)),
                           0);
      std::uniform_real_distribution<double> x(1, 22);
      std::uniform_real_distribution<double> y(1, 16);
      const std::vector<FinePoint> path{at(x(random), y(random)), at(x(random), y(random)),
                                        at(x(random), y(random))};
      if (!free.canSee(path[0], path[1]) || !free.canSee(path[1], path[2])) continue;
      const double sampled = sampledClearance(scene, obstacles, path);
      const double exact = pathClearancePx(free, obstacles, path);
      if (std::isinf(sampled)) {
        EXPECT_TRUE(std::isinf(exact));
        continue;
      }
      EXPECT_LE(exact, sampled + 1e-9) << "trial " << trial;
      EXPECT_GE(exact, sampled - 0.06) << "trial " << trial;
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(DoorBetween, IsTheNearestOneThatJoinsBoth) {
  AreaMap areas;
  for (std::uint32_t i = 1; i <= 3; ++i) {
    areas.areas.emplace_back();
    areas.areas.back().id = AreaId{i};
  }
  const auto add = [&](AreaId a, AreaId b, double x) {
    areas.doors.emplace_back();
    areas.doors.back().areas = {a, b};
    areas.doors.back().jambs_map = {{x, 0}, {x, 1}};
  };
  add(AreaId{1}, AreaId{2}, 0);
  add(AreaId{2}, AreaId{1}, 10);
  add(AreaId{2}, AreaId{3}, 6);
  EXPECT_EQ(doorBetween(areas, 0, 1, {4, 0}), 0U);
  EXPECT_EQ(doorBetween(areas, 0, 1, {6, 0}), 1U);
  EXPECT_EQ(doorBetween(areas, 2, 1, {0, 0}), 2U);
  EXPECT_EQ(doorBetween(areas, 0, 2, {0, 0}), kNoDoor);
}

}  // namespace
}  // namespace agrid::planning
