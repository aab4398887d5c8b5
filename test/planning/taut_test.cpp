// SPDX-License-Identifier: BSD-3-Clause
#include "planning/taut.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

Road roadBetween(const RoadSample& s, Pixel start, Pixel goal) {
  Target target;
  target.point = centerOf(goal);
  target.regions = {s.regionAt(goal)};
  target.box.add(goal);
  return RoadSearch(*s.level).find({centerOf(start), s.regionAt(start), &target}, {});
}

void expectFree(const RoadSample& s, const Road& road) {
  for (std::size_t i = 1; i < road.corners.size(); ++i) {
    EXPECT_TRUE(s.free().canSee(road.corners[i - 1].at, road.corners[i].at)) << "leg " << i;
  }
}

double crossOf(const Point2& a, const Point2& b) { return std::abs(a.x() * b.y() - a.y() * b.x()); }

/// No corner can be left out, and none moved towards the line between its neighbours.
void expectTaut(const RoadSample& s, const Road& road) {
  for (std::size_t i = 1; i + 1 < road.corners.size(); ++i) {
    const FinePoint a = road.corners[i - 1].at;
    const FinePoint b = road.corners[i].at;
    const FinePoint c = road.corners[i + 1].at;
    EXPECT_NE(road.corners[i].blocked_x, 0) << "corner " << i;
    const Point2 before = coordinates(b) + (coordinates(a) - coordinates(b)) / 64;
    const Point2 after = coordinates(b) + (coordinates(c) - coordinates(b)) / 64;
    // The corner of the pixel lies a step of the lattice beside the path's.
    const double swing = crossOf(after - before, coordinates(b) - before) / (after - before).norm();
    if (swing < 1e-4) continue;
    EXPECT_FALSE(s.free().canSee(finePoint(before), finePoint(after))) << "corner " << i;
  }
}

TEST(PullTaut, MakesRoadsTautFreeAndNeverLonger) {
  std::mt19937 random(56);
  int pulled = 0;
  int failed = 0;
  double before = 0;
  double after = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    if (pixels.empty()) continue;
    const Pixel p = pixels[random() % pixels.size()];
    const Pixel q = pixels[random() % pixels.size()];
    if (s.regions().componentOf(s.regionAt(p)) != s.regions().componentOf(s.regionAt(q))) continue;
    const Road road = roadBetween(s, p, q);
    expectFree(s, road);
    Road taut = road;
    const bool all = pullTaut(s.free(), s.roadmap(), taut);
    EXPECT_TRUE(taut.corners.front().at == centerOf(p));
    EXPECT_TRUE(taut.corners.back().at == centerOf(q));
    EXPECT_LE(lengthPx(taut), lengthPx(road) + 1e-9);
    expectFree(s, taut);
    if (all) expectTaut(s, taut);
    failed += all ? 0 : 1;
    pulled += lengthPx(taut) < lengthPx(road) - 1e-6 ? 1 : 0;
    before += lengthPx(road);
    after += lengthPx(taut);
    if (HasFailure()) return;
  }
  EXPECT_GT(pulled, 150);
  // Where a leg runs along a wall on the lattice, a corner may stay.
  EXPECT_LE(failed, 8);
  EXPECT_LT(after, 0.998 * before);
}

/// Through a gap above a wall and one below the next, over borders between areas.
TEST(PullTaut, GoesAroundTheTwoCornersOfASlalom) {
  test::Scene scene = test::sceneOf({
      ".............#.......",  // y = 10
      ".............#.......",
      ".............#.......",
      ".............#.......",
      "......#......#.......",
      "......#......#.......",
      "......#......#.......",
      "......#..............",
      "......#..............",
      "......#..............",
      "......#..............",
  });
  scene.areas.assign(11, "AAABBBBBBCCCCCCDDDDDD");
  const RoadSample s = test::roadSample(std::move(scene), {});
  Road road = roadBetween(s, {2, 1}, {18, 7});
  ASSERT_TRUE(pullTaut(s.free(), s.roadmap(), road));
  // Up the first wall to its top (5.5, 6.5), down to the foot of the second, (13.5, 3.5).
  const std::vector<Point2> corners{{2, 1},      {5.5, 6.5},  {6.5, 6.5},
                                    {12.5, 3.5}, {13.5, 3.5}, {18, 7}};
  ASSERT_EQ(road.corners.size(), corners.size());
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_LT((coordinates(road.corners[i].at) - corners[i]).norm(), 1e-4) << "corner " << i;
    if (i > 0) length += (corners[i] - corners[i - 1]).norm();
  }
  EXPECT_NEAR(lengthPx(road), length, 1e-3);
  EXPECT_LE(road.length_bound_px, length);
}

/// A road that swings out is pulled back to the corners that lie inside of it.
TEST(PullTaut, PullsADetourToTheHullOfTheCornersInside) {
  const RoadSample s = test::roadSample(test::sceneOf({
                                            ".................",  // y = 9
                                            ".................",
                                            ".................",
                                            ".................",
                                            ".................",
                                            ".................",
                                            ".....#...........",
                                            ".....#.....##....",
                                            ".................",
                                            ".................",
                                        }),
                                        {});
  Road road;
  road.regions = {s.regionAt({2, 2})};
  road.corners = {{centerOf({2, 2}), 0, 0, 0, 0},
                  {centerOf({8, 8}), 0, 0, 0, 0},
                  {centerOf({14, 2}), 0, 0, 0, 0}};
  ASSERT_TRUE(pullTaut(s.free(), s.roadmap(), road));
  const std::vector<Point2> corners{{2, 2}, {4.5, 3.5}, {5.5, 3.5}, {12.5, 2.5}, {14, 2}};
  ASSERT_EQ(road.corners.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_LT((coordinates(road.corners[i].at) - corners[i]).norm(), 1e-4) << "corner " << i;
  }
}

}  // namespace
}  // namespace agrid::planning
