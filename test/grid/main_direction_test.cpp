// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/main_direction.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "grid/edge_frame.h"
#include "grid/edge_image.h"
#include "support/floor_plan.h"

namespace agrid {
namespace {

constexpr double kDegree = 3.14159265358979 / 180;

double directionOfPlan(unsigned seed, double turn_deg) {
  std::mt19937 random(seed);
  const OccupancyMap map(test::drawPlan(test::randomFloorPlan(random), turn_deg));
  return mainDirection(sampleEdges(detectEdges(map, {}))) / kDegree;
}

/// The difference of two directions of walls, which are alike every 90 degrees.
double differenceDeg(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 90));
}

TEST(MainDirection, FindsTheTurnOfAFloorPlanWithinAThirdOfADegree) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> turn(2.5, 87.5);
  for (unsigned seed = 1; seed <= 15; ++seed) {
    const double turn_deg = turn(random);
    EXPECT_LT(differenceDeg(directionOfPlan(seed, turn_deg), turn_deg), 0.3) << turn_deg;
  }
}

TEST(MainDirection, UprightAndNearlyUprightPlansGiveExactlyZero) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    EXPECT_EQ(directionOfPlan(seed, 0), 0);
    EXPECT_EQ(directionOfPlan(seed, 90), 0);
    EXPECT_EQ(directionOfPlan(seed, 0.5), 0);
  }
}

TEST(MainDirection, PointsWithoutStructureGiveExactlyZero) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> place(0, 500);
  std::vector<Point2> points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(place(random), place(random));
  EXPECT_EQ(mainDirection(points), 0);
  EXPECT_EQ(mainDirection({}), 0);
  EXPECT_EQ(mainDirection({{3, 4}}), 0);
  EXPECT_EQ(mainDirection({{3, 4}, {3, 4}}), 0);
}

/// Points one unit apart on parallel lines of 300, ten apart, of this direction.
void addLines(std::vector<Point2>& points, int count, double direction_deg) {
  const Pose2 turn{Point2(500 * direction_deg, 0), direction_deg * kDegree};
  for (int line = 0; line < count; ++line) {
    for (int i = 0; i < 300; ++i) points.push_back(turn * Point2(i, 10 * line));
  }
}

TEST(MainDirection, TwoWingsStayUprightUnlessTheTurnedOneIsTwiceAsClear) {
  std::vector<Point2> points;
  addLines(points, 10, 0);
  addLines(points, 13, 30);
  EXPECT_EQ(mainDirection(points), 0);
  addLines(points, 20, 30);
  EXPECT_NEAR(mainDirection(points) / kDegree, 30, 0.3);
}

TEST(MainDirection, IsBelievedByItsParameters) {
  std::vector<Point2> points;
  addLines(points, 10, 0.5);
  DirectionParams params;
  params.min_gain = 0;
  EXPECT_EQ(mainDirection(points, params), 0) << "below snap_deg";
  params.snap_deg = 0.2;
  EXPECT_NEAR(mainDirection(points, params) / kDegree, 0.5, 0.1);
  params.min_contrast = 1e9;
  EXPECT_EQ(mainDirection(points, params), 0);
}

TEST(MainDirection, ADiagonalBuildingLiesAtPlus45Degrees) {
  EXPECT_NEAR(directionOfPlan(3, 45), 45, 0.3);
}

}  // namespace
}  // namespace agrid
