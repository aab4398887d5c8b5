// SPDX-License-Identifier: BSD-3-Clause
#include "tags/sight.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/measured_space.h"

namespace agrid {
namespace {

const Point2 kRight(1, 0);
const Point2 kUp(0, 1);

/// Free space of 60 x 40 pixels.
cv::Mat1b openSpace() { return cv::Mat1b(40, 60, std::uint8_t{1}); }

TEST(Sight, TurnsMetresIntoPixelsAndBack) {
  const cv::Mat1b space = openSpace();
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  EXPECT_DOUBLE_EQ(sight.pixels(2), 40);
  EXPECT_DOUBLE_EQ(sight.metres(40), 2);
}

TEST(Sight, WhatLiesBeyondTheMapIsWall) {
  const cv::Mat1b space = openSpace();
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  EXPECT_FALSE(sight.isWall({0, 0}));
  EXPECT_FALSE(sight.isWall({59.9, 39.9}));
  EXPECT_TRUE(sight.isWall({-0.1, 5}));
  EXPECT_TRUE(sight.isWall({5, -0.1}));
  EXPECT_TRUE(sight.isWall({60, 5}));
  EXPECT_TRUE(sight.isWall({5, 40}));
  EXPECT_DOUBLE_EQ(sight.freeRun({50, 20.5}, kRight, 100), 10);
  EXPECT_NEAR(sight.freeRun({10, 20.5}, -kRight, 100), 10, 0.5);
  EXPECT_DOUBLE_EQ(sight.wallRun({60.5, 20.5}, kRight, 25), 25);
}

TEST(Sight, AFreeRunEndsAtTheFirstWallOrAtItsReach) {
  cv::Mat1b space = openSpace();
  space.colRange(30, 32) = 0;
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  EXPECT_DOUBLE_EQ(sight.freeRun({10, 20.5}, kRight, 100), 20);
  EXPECT_DOUBLE_EQ(sight.freeRun({10, 20.5}, kRight, 7.3), 7.3);
  EXPECT_DOUBLE_EQ(sight.freeRun({31, 20.5}, kRight, 100), 0);
  const Point2 aslant = Point2(3, 4).normalized();
  EXPECT_NEAR(sight.freeRun({21, 5}, aslant, 100), 9 / aslant.x(), 0.5);
}

TEST(Sight, AFreeRunIsWhatSmallStepsFind) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> part(0, 1);
  for (int run = 0; run < 200; ++run) {
    cv::Mat1b space = openSpace();
    for (std::uint8_t& pixel : space) pixel = random() % (run % 2 == 0 ? 20 : 400) == 0 ? 0 : 1;
    const test::MeasuredSpace measured(space, 0.05);
    const Point2 start(part(random) * space.cols, part(random) * space.rows);
    const double angle = part(random) * 7;
    const Point2 direction(std::cos(angle), std::sin(angle));
    const double reach = part(random) * 60;
    double expected = 0;
    while (expected < reach && !measured.sight.isWall(start + direction * expected))
      expected += 0.5;
    EXPECT_NEAR(measured.sight.freeRun(start, direction, reach), std::min(expected, reach), 1e-9);
  }
}

TEST(Sight, AWallRunMayLieBesideTheLine) {
  cv::Mat1b space = openSpace();
  space(cv::Rect(10, 20, 15, 1)) = 0;
  const test::MeasuredSpace coarse_space(space, 0.05);
  const Sight& coarse = coarse_space.sight;  // tolerates one pixel
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 20.5}, kRight, 100), 15);
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 21.5}, kRight, 100), 15);
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 19.5}, kRight, 100), 15);
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 22.5}, kRight, 100), 0);
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 18.5}, kRight, 100), 0);
  EXPECT_DOUBLE_EQ(coarse.wallRun({10, 20.5}, kRight, 6), 6);
  EXPECT_DOUBLE_EQ(coarse.wallRun({9, 20.5}, kRight, 100), 0) << "begins in free space";
  const test::MeasuredSpace fine_space(space, 0.025);
  const Sight& fine = fine_space.sight;  // two pixels
  EXPECT_DOUBLE_EQ(fine.wallRun({10, 22.5}, kRight, 100), 15);
  EXPECT_DOUBLE_EQ(fine.wallRun({10, 23.5}, kRight, 100), 0);
}

TEST(Sight, AWallMayStrayWithTheDistance) {
  cv::Mat1b space(40, 300, std::uint8_t{1});
  for (int x = 10; x < 300; ++x) space(20 + (x - 10) / 75, x) = 0;
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  EXPECT_DOUBLE_EQ(sight.wallRun({10, 20.5}, kRight, 280), 280);
  EXPECT_DOUBLE_EQ(sight.wallShare({10, 20.5}, kRight, 280), 1);
  EXPECT_TRUE(sight.isWallBeside({10, 20.5}, kRight, 280)) << "three pixels aside";
  EXPECT_FALSE(sight.isWallBeside({270, 20.5}, kRight, 20)) << "as many, but near the start";
}

TEST(Sight, TheWallShareCountsGapsToo) {
  cv::Mat1b space = openSpace();
  space(cv::Rect(10, 20, 5, 1)) = 0;
  space(cv::Rect(25, 21, 3, 1)) = 0;
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  EXPECT_DOUBLE_EQ(sight.wallShare({10, 20.5}, kRight, 20), 8. / 20);
  EXPECT_DOUBLE_EQ(sight.wallShare({10, 20.5}, kRight, 5), 1);
  EXPECT_DOUBLE_EQ(sight.wallShare({10.5, 30.5}, kUp, 8), 0);
  EXPECT_DOUBLE_EQ(sight.wallShare({10, 20.5}, kRight, 0), 0);
}

TEST(Sight, AWallAcrossTheLineIsAFlatEnd) {
  cv::Mat1b space = openSpace();
  space.colRange(40, 60) = 0;
  const test::MeasuredSpace sight_space(space, 0.05);
  const Sight& sight = sight_space.sight;
  const Sight::End end = sight.endOf({10, 20.5}, kRight, 30);
  EXPECT_TRUE(end.is_flat);
  EXPECT_DOUBLE_EQ(end.slope, 0);
}

TEST(Sight, ASlopedWallIsAFlatEndWithItsSlope) {
  for (const double slope : {-0.5, -0.25, 0.25, 0.5}) {
    cv::Mat1b space = openSpace();
    for (int y = 0; y < space.rows; ++y) {
      for (int x = 0; x < space.cols; ++x) {
        if (x + 0.5 > 40 + slope * (y + 0.5 - 20.5)) space(y, x) = 0;
      }
    }
    const test::MeasuredSpace sight_space(space, 0.05);
    const Sight& sight = sight_space.sight;
    const Sight::End end = sight.endOf({10, 20.5}, kRight, 30);
    EXPECT_TRUE(end.is_flat) << slope;
    EXPECT_NEAR(end.slope, std::abs(slope), 0.2) << slope;
  }
}

TEST(Sight, TheEndOfAWallOnTheLineIsNotFlat) {
  cv::Mat1b space = openSpace();
  space(cv::Rect(40, 19, 20, 3)) = 0;
  const test::MeasuredSpace wall_ahead_space(space, 0.05);
  const Sight& wall_ahead = wall_ahead_space.sight;
  EXPECT_FALSE(wall_ahead.endOf({10, 20.5}, kRight, 30).is_flat);

  space = openSpace();
  space(cv::Rect(40, 0, 20, 21)) = 0;
  const test::MeasuredSpace corner_space(space, 0.05);
  const Sight& corner = corner_space.sight;
  EXPECT_FALSE(corner.endOf({10, 20.5}, kRight, 30).is_flat) << "free on one side";

  space = openSpace();
  space.colRange(40, 60) = 0;
  space(cv::Rect(8, 22, 20, 18)) = 0;
  const test::MeasuredSpace beside_space(space, 0.05);
  const Sight& beside = beside_space.sight;
  EXPECT_FALSE(beside.endOf({10, 20.5}, kRight, 30).is_flat) << "a wall along the line";
}

}  // namespace
}  // namespace agrid
