// SPDX-License-Identifier: BSD-3-Clause
#include "planning/local_road.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

/// Over all sights between the region's turning points and the ends, whether a shortest path can
/// bend there or not.
double shortest(const RoadSample& s, const RoadEnd& start, const RoadEnd& goal) {
  const auto& points = start.roads().points();
  const auto at = [&](std::size_t i) {
    return i == 0 ? start.point() : i == 1 ? goal.point() : points[i - 2].at;
  };
  const auto corner = [&](std::size_t i) { return i < 2 ? at(i) : points[i - 2].corner(); };
  return test::lengthsFrom(0, points.size() + 2, [&](std::size_t i, std::size_t k) {
    return s.free().canSee(at(i), at(k)) ? distancePx(corner(i), corner(k))
                                         : std::numeric_limits<double>::infinity();
  })[1];
}

TEST(LocalRoad, IsTheShortestAroundTheRegionsTurningPoints) {
  std::mt19937 random(53);
  int compared = 0;
  for (int trial = 0; trial < 800; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    for (int i = 0; i < 20 && !pixels.empty(); ++i) {
      const Pixel p = pixels[random() % pixels.size()];
      const Pixel q = pixels[random() % pixels.size()];
      if (s.regionAt(p) != s.regionAt(q) || s.free().canSee(centerOf(p), centerOf(q))) continue;
      RoadEnd start(s.free(), s.roadmap(), centerOf(p), s.regionAt(p));
      RoadEnd goal(s.free(), s.roadmap(), centerOf(q), s.regionAt(q));
      const LocalRoad road = findLocalRoad(start, goal);
      const double expected = shortest(s, start, goal);
      ASSERT_EQ(road.length == kUnreachable, std::isinf(expected));
      if (road.length == kUnreachable) continue;
      ASSERT_NEAR(road.length, expected, 1e-3);
      ++compared;
      FinePoint here = start.point();
      double sum = 0;
      for (const RegionRoads::Node node : road.nodes) {
        EXPECT_TRUE(s.free().canSee(here, start.roads().at(node)));
        sum += distancePx(here, start.roads().at(node));
        here = start.roads().at(node);
      }
      EXPECT_TRUE(s.free().canSee(here, goal.point()));
      EXPECT_NEAR(sum + distancePx(here, goal.point()), road.length, 1e-2);
    }
  }
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace agrid::planning
