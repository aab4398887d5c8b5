// SPDX-License-Identifier: BSD-3-Clause
#include "tags/wall_corners.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/drawn_plan.h"

namespace agrid {
namespace {

using test::DrawnPlan;

constexpr double kDegree = 3.14159265358979323846 / 180;

Point2 wallAt(double degrees, double length_px) {
  return Point2(std::cos(degrees * kDegree), std::sin(degrees * kDegree)) * length_px;
}

/// The angle from one line to another, in [-90, 90] degrees.
double turnOf(const Point2& from, const Point2& to) {
  const double turn = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
  return std::remainder(turn, 180 * kDegree) / kDegree;
}

bool hasCornerNear(const std::vector<WallCorner>& corners, const Point2& point, double reach) {
  return std::any_of(corners.begin(), corners.end(), [&](const WallCorner& corner) {
    return (corner.point - point).norm() <= reach;
  });
}

DrawnPlan hall() { return DrawnPlan(12, 8).open({1, 1}, {11, 7}); }

WallDirections directionsOf(const DrawnPlan& plan) {
  return {findWallCorners(plan.freeSpace(), plan.resolution()), plan.resolution()};
}

TEST(WallCorners, ARectangleHasFour) {
  cv::Mat1b space(50, 80, std::uint8_t{0});
  space(cv::Rect(10, 15, 40, 20)) = 1;
  const auto corners = findWallCorners(space, 0.05);
  ASSERT_EQ(corners.size(), 4U);
  for (const Point2& expected :
       {Point2(10.5, 15.5), Point2(49.5, 15.5), Point2(49.5, 34.5), Point2(10.5, 34.5)}) {
    EXPECT_TRUE(hasCornerNear(corners, expected, 1e-9)) << expected.transpose();
  }
  for (const WallCorner& corner : corners) {
    EXPECT_NEAR(corner.arms[0].dot(corner.arms[1]), 0, 1e-9);
    EXPECT_NEAR(std::min(corner.arms[0].norm(), corner.arms[1].norm()), 19, 1e-9);
    EXPECT_NEAR(std::max(corner.arms[0].norm(), corner.arms[1].norm()), 39, 1e-9);
    for (const Point2& arm : corner.arms) {
      EXPECT_TRUE(hasCornerNear(corners, corner.point + arm, 1e-9)) << "arms end at corners";
    }
  }
}

TEST(WallCorners, FreeSpaceMayTouchTheMapsBorder) {
  const cv::Mat1b space(30, 40, std::uint8_t{1});
  EXPECT_EQ(findWallCorners(space, 0.05).size(), 4U);
  EXPECT_TRUE(findWallCorners(cv::Mat1b(30, 40, std::uint8_t{0}), 0.05).empty());
}

TEST(WallCorners, TurnedWallsAreStraightened) {
  for (const double degrees : {3., 7., 20., 30., 45., 71.}) {
    const DrawnPlan plan = hall().at(0.05, degrees);
    const auto corners = findWallCorners(plan.freeSpace(), 0.05);
    EXPECT_EQ(corners.size(), 4U) << degrees;
    for (const Point2& corner : {Point2(1, 1), Point2(11, 1), Point2(11, 7), Point2(1, 7)}) {
      EXPECT_TRUE(hasCornerNear(corners, plan.inImage(corner), 3)) << degrees;
    }
  }
}

TEST(WallCorners, ObstaclesInFreeSpaceHaveCornersToo) {
  const DrawnPlan plan = hall().close({4, 3}, {5.5, 4});
  const auto corners = findWallCorners(plan.freeSpace(), 0.05);
  EXPECT_EQ(corners.size(), 8U);
  for (const Point2& corner : {Point2(4, 3), Point2(5.5, 3), Point2(5.5, 4), Point2(4, 4)}) {
    EXPECT_TRUE(hasCornerNear(corners, plan.inImage(corner), 2));
  }
}

TEST(WallCorners, NichesBelowTheStraighteningAreNone) {
  const DrawnPlan shallow = hall().open({4, 7}, {6, 7.1});
  EXPECT_EQ(findWallCorners(shallow.freeSpace(), 0.05).size(), 4U);
  const DrawnPlan deep = hall().open({4, 7}, {6, 7.3});
  EXPECT_EQ(findWallCorners(deep.freeSpace(), 0.05).size(), 8U);
}

TEST(WallDirections, ShortWallsTakeTheDirectionOfTheLongOnes) {
  for (const double building : {0., 20., 45., 88.}) {
    const WallDirections directions = directionsOf(hall().at(0.05, building));
    for (const double error : {-8., -3., 3., 8.}) {
      for (const double across : {0., 90., 180.}) {
        const Point2 wall = wallAt(building + across + error, 10);
        const auto aligned = directions.align(wall);
        ASSERT_TRUE(aligned) << building << " " << error;
        EXPECT_NEAR(aligned->norm(), 1, 1e-9);
        EXPECT_NEAR(turnOf(wallAt(building, 1), *aligned) - across,
                    180 * std::round((turnOf(wallAt(building, 1), *aligned) - across) / 180), 0.7)
            << building << " " << error;
        EXPECT_GT(aligned->dot(wall), 0) << "points the way of the wall";
      }
    }
  }
}

TEST(WallDirections, TheLongWallsOutweighTheManyShortOnes) {
  // two walls of 10 m at 0 degrees against four of 1.5 m at 6 degrees
  std::vector<WallCorner> corners;
  for (int i = 0; i < 2; ++i) corners.push_back({{0, 0}, {Point2(0, 1), wallAt(0, 200)}});
  for (int i = 0; i < 4; ++i) corners.push_back({{0, 0}, {Point2(0, 1), wallAt(6, 30)}});
  const auto aligned = WallDirections(corners, 0.05).align(wallAt(4, 12));
  ASSERT_TRUE(aligned);
  EXPECT_NEAR(turnOf(wallAt(0, 1), *aligned), 0, 0.1);
}

TEST(WallDirections, AChippedCornerHasNone) {
  const WallDirections directions = directionsOf(hall());
  EXPECT_FALSE(directions.align(wallAt(45, 6)));
  EXPECT_TRUE(directions.align(wallAt(0, 6)));
}

TEST(WallDirections, ALongWallKeepsItsOwn) {
  const WallDirections directions = directionsOf(hall());
  const auto slanted = directions.align(wallAt(45, 60));
  ASSERT_TRUE(slanted);
  EXPECT_NEAR(turnOf(wallAt(45, 1), *slanted), 0, 1e-6);
  const auto nearly = directions.align(wallAt(6, 100));
  ASSERT_TRUE(nearly);
  EXPECT_NEAR(turnOf(wallAt(6, 1), *nearly), 0, 1e-6) << "straightening turns it by 1.4 degrees";
}

TEST(WallDirections, WallsBelowAMetreSayNothing) {
  const std::vector<WallCorner> corners(5, {{0, 0}, {Point2(0, 1), wallAt(10, 19)}});
  const auto aligned = WallDirections(corners, 0.05).align(wallAt(13, 30));
  ASSERT_TRUE(aligned);
  EXPECT_NEAR(turnOf(wallAt(13, 1), *aligned), 0, 1e-6);
}

}  // namespace
}  // namespace agrid
