// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/drawn_plan.h"
#include "support/measured_space.h"
#include "tags/openings.h"

namespace agrid {
namespace {

using test::DrawnPlan;

std::vector<Opening> gapsOf(const DrawnPlan& plan) {
  const cv::Mat1b space = plan.freeSpace();
  const test::MeasuredSpace measured(space, plan.resolution());
  const Sight& sight = measured.sight;
  const auto corners = findWallCorners(space, plan.resolution());
  return findWallGaps(corners, WallDirections(corners, plan.resolution()), sight);
}

/// Distance between the jambs of two openings, whichever is called a [px].
double apart(const Segment& p, const Segment& q) {
  return std::min(std::max((p.a - q.a).norm(), (p.b - q.b).norm()),
                  std::max((p.a - q.b).norm(), (p.b - q.a).norm()));
}

/// Distance of the nearest gap from where one is expected, [m] of the plan to [px].
double nearestTo(const DrawnPlan& plan, const std::vector<Opening>& gaps, const Segment& expected) {
  const Segment jambs{plan.inImage(expected.a), plan.inImage(expected.b)};
  double nearest = 1e9;
  for (const Opening& gap : gaps) nearest = std::min(nearest, apart(gap.jambs, jambs));
  return nearest;
}

/// Two rooms and a door of 0.9 m between them.
DrawnPlan twoRooms() {
  return DrawnPlan(10, 6)
      .open({0.5, 0.5}, {4.9, 5.5})
      .open({5.1, 0.5}, {9.5, 5.5})
      .open({4.5, 2.5}, {5.5, 3.4});
}

TEST(WallGaps, ADoorInAStraightWallHasItsJambsOnTheWallsSurface) {
  const DrawnPlan plan = twoRooms();
  const auto gaps = gapsOf(plan);
  ASSERT_FALSE(gaps.empty());
  for (const Opening& gap : gaps) {
    EXPECT_NEAR(gap.jambs.length(), 18, 0.5);
    for (const Point2& jamb : {gap.jambs.a, gap.jambs.b}) {
      EXPECT_NEAR(jamb.x(), 100, 2.01) << "within the wall's thickness";
    }
    EXPECT_NEAR(std::min(gap.jambs.a.y(), gap.jambs.b.y()), 50, 0.5);
    EXPECT_NEAR(std::max(gap.jambs.a.y(), gap.jambs.b.y()), 68, 0.5);
    EXPECT_GT(gap.wall_before, 35) << "2 m of wall";
    EXPECT_GT(gap.wall_beyond, 35);
  }
}

TEST(WallGaps, ADoorInATurnedWallIsFound) {
  for (const double degrees : {7., 30., 45., 60., 83.}) {
    const DrawnPlan plan = twoRooms().at(0.05, degrees);
    const auto gaps = gapsOf(plan);
    ASSERT_FALSE(gaps.empty()) << degrees;
    double nearest = 1e9;
    for (const double x : {4.9, 5., 5.1}) {
      nearest = std::min(nearest, nearestTo(plan, gaps, {{x, 2.5}, {x, 3.4}}));
    }
    EXPECT_LE(nearest, 1.5) << degrees;
  }
}

TEST(WallGaps, ADoorIsAsWideInMapsOfOtherResolutions) {
  for (const double resolution : {0.02, 0.025, 0.1}) {
    const auto gaps = gapsOf(twoRooms().at(resolution));
    ASSERT_FALSE(gaps.empty()) << resolution;
    for (const Opening& gap : gaps) EXPECT_NEAR(gap.jambs.length() * resolution, 0.9, resolution);
  }
}

TEST(WallGaps, AWallMayBeOnePixelThick) {
  for (const double resolution : {0.05, 0.1, 0.2, 0.5}) {
    for (const int thickness : {1, 2, 3}) {
      cv::Mat1b space(41, 65, std::uint8_t{0});
      space(cv::Rect(5, 5, 25, 31)) = 1;
      space(cv::Rect(30 + thickness, 5, 25, 31)) = 1;
      const int width = static_cast<int>(std::lround(1 / resolution));
      space(cv::Rect(30, 12, thickness, width)) = 1;
      const test::MeasuredSpace measured(space, resolution);
      const Sight& sight = measured.sight;
      const auto corners = findWallCorners(space, resolution);
      const auto gaps = findWallGaps(corners, WallDirections(corners, resolution), sight);
      ASSERT_FALSE(gaps.empty()) << resolution << " " << thickness;
      for (const Opening& gap : gaps) {
        EXPECT_NEAR(gap.jambs.length(), width, 0.51) << resolution << " " << thickness;
        EXPECT_NEAR(gap.jambs.midpoint().x(), 30 + thickness / 2., thickness / 2. + 0.01);
        EXPECT_NEAR(gap.jambs.midpoint().y(), 12 + width / 2., 0.5);
      }
    }
  }
}

TEST(WallGaps, EachOfARowOfCubiclesHasItsOpening) {
  DrawnPlan plan(10, 6);
  plan.open({0.5, 0.5}, {9.5, 3}).open({0.5, 3}, {9.5, 5.5});
  // four cubicles of 2.1 m, their fronts open but for stubs of 0.3 m on either side
  for (const double x : {2.6, 4.9, 7.2}) plan.close({x, 3}, {x + 0.2, 5.5});
  for (const double x : {0.5, 2.3, 4.6, 6.9, 9.2}) {
    plan.close({x, 3}, {x + (x == 0.5 || x == 9.2 ? 0.3 : 0.8), 3.2});
  }
  const auto gaps = gapsOf(plan);
  for (const auto& [left, right] : {std::pair(0.8, 2.3), {3.1, 4.6}, {5.4, 6.9}, {7.7, 9.2}}) {
    double nearest = 1e9;
    for (const double y : {3., 3.05, 3.1, 3.15, 3.2}) {
      nearest = std::min(nearest, nearestTo(plan, gaps, {{left, y}, {right, y}}));
    }
    EXPECT_LE(nearest, 1.5) << left;
  }
}

TEST(WallGaps, AnOpeningAtTheEndOfAWallIsFound) {
  // the wall between both rooms ends 1 m before the outer wall
  const DrawnPlan plan = DrawnPlan(10, 6).open({0.5, 0.5}, {9.5, 5.5}).close({4.9, 0}, {5.1, 4.5});
  const auto gaps = gapsOf(plan);
  ASSERT_FALSE(gaps.empty());
  for (const Opening& gap : gaps) {
    EXPECT_NEAR(gap.jambs.length(), 20, 0.5);
    EXPECT_NEAR(gap.jambs.midpoint().x(), 100, 2.01);
    EXPECT_NEAR(gap.jambs.midpoint().y(), 100, 0.5);
  }
}

TEST(WallGaps, NoneAcrossACorridorAtFacingDoors) {
  for (const double thickness : {0.1, 0.2, 0.3}) {
    const DrawnPlan plan = DrawnPlan(13, 10)
                               .open({0.5, 4}, {12.5, 6})
                               .open({0.5, 0.5}, {12.5, 4 - thickness})
                               .open({0.5, 6 + thickness}, {12.5, 9.5})
                               .open({6, 3.5}, {6.9, 6.5});
    const auto gaps = gapsOf(plan);
    EXPECT_GE(gaps.size(), 2U) << thickness;
    for (const Opening& gap : gaps) {
      const Point2 way = gap.jambs.b - gap.jambs.a;
      EXPECT_GT(std::abs(way.x()), std::abs(way.y())) << thickness << ": along the walls";
      EXPECT_NEAR(way.norm(), 18, 0.5) << thickness;
    }
  }
}

TEST(WallGaps, NoneBesideAColumn) {
  for (const double side : {0.3, 0.4, 0.5}) {
    const DrawnPlan plan =
        DrawnPlan(7, 7).open({0.5, 0.5}, {6.5, 6.5}).close({3, 3}, {3 + side, 3 + side});
    EXPECT_TRUE(gapsOf(plan).empty()) << side;
  }
}

TEST(WallGaps, NoneAboveFourMetresOrBelowForty) {
  const auto withGap = [](double width) {
    return DrawnPlan(12, 6)
        .open({0.5, 0.5}, {11.5, 2.9})
        .open({0.5, 3.1}, {11.5, 5.5})
        .open({3, 2.5}, {3 + width, 3.5});
  };
  EXPECT_TRUE(gapsOf(withGap(0.35)).empty());
  EXPECT_FALSE(gapsOf(withGap(0.5)).empty());
  EXPECT_FALSE(gapsOf(withGap(3.9)).empty());
  EXPECT_TRUE(gapsOf(withGap(4.2)).empty());
}

TEST(WallGaps, NoneInAnEmptyRoom) {
  for (const double degrees : {0., 12., 45.}) {
    EXPECT_TRUE(gapsOf(DrawnPlan(7, 5).open({0.5, 0.5}, {6.5, 4.5}).at(0.05, degrees)).empty());
  }
}

}  // namespace
}  // namespace agrid
