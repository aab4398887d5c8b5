// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/drawn_plan.h"
#include "support/measured_space.h"
#include "tags/openings.h"

namespace agrid {
namespace {

using test::DrawnPlan;

std::vector<Opening> mouthsOf(const cv::Mat1b& space, double resolution) {
  const test::MeasuredSpace measured(space, resolution);
  const Sight& sight = measured.sight;
  const auto corners = findWallCorners(space, resolution);
  return findMouths(corners, WallDirections(corners, resolution), sight);
}

std::vector<Opening> mouthsOf(const DrawnPlan& plan) {
  return mouthsOf(plan.freeSpace(), plan.resolution());
}

DrawnPlan neckIntoHall(double width) {
  return DrawnPlan(12, 8).open({5.5, 0.5}, {11.5, 7.5}).open({0.5, 3}, {5.5, 3 + width});
}

/// A neck of 1.5 m that spreads to both sides from x = 4 m on, at 0.05 m.
cv::Mat1b funnel(double degrees) {
  const double rise = std::tan(degrees * 3.14159265358979323846 / 180) * 60;
  const auto at = [](double x, double y) {
    return cv::Point(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
  };
  const std::vector<cv::Point> outline{at(10, 65),         at(80, 65), at(140, 65 - rise),
                                       at(140, 95 + rise), at(80, 95), at(10, 95)};
  cv::Mat1b space(160, 160, std::uint8_t{0});
  cv::fillPoly(space, std::vector<std::vector<cv::Point>>{outline}, 1);
  return space;
}

TEST(Mouths, ANeckOpensIntoAHall) {
  for (const double width : {0.6, 1.5, 2.5}) {
    const auto mouths = mouthsOf(neckIntoHall(width));
    ASSERT_EQ(mouths.size(), 1U) << width;
    const Segment& jambs = mouths[0].jambs;
    EXPECT_NEAR(jambs.length(), width * 20, 1.1) << width;
    EXPECT_NEAR(jambs.midpoint().x(), 110, 1.6) << width;
    EXPECT_NEAR(jambs.midpoint().y(), 60 + width * 10, 1.1) << width;
    EXPECT_GT(mouths[0].wall_before, 40) << "on the wall of the hall";
    EXPECT_GT(mouths[0].wall_beyond, 40);
  }
}

TEST(Mouths, ATurnedNeckOpensIntoAHallToo) {
  for (const double degrees : {7., 30., 45.}) {
    const DrawnPlan plan = neckIntoHall(1.5).at(0.05, degrees);
    const auto mouths = mouthsOf(plan);
    ASSERT_EQ(mouths.size(), 1U) << degrees;
    EXPECT_LE((mouths[0].jambs.midpoint() - plan.inImage({5.5, 3.75})).norm(), 3) << degrees;
    EXPECT_NEAR(mouths[0].jambs.length(), 30, 3) << degrees;
  }
}

TEST(Mouths, AFunnelIsOneFromTwentyDegreesOn) {
  EXPECT_EQ(mouthsOf(funnel(35), 0.05).size(), 1U);
  EXPECT_TRUE(mouthsOf(funnel(10), 0.05).empty());
}

TEST(Mouths, AWaistWhoseWallsSpreadLittleIsNone) {
  // walls that come together by 15 degrees and spread again by 10
  cv::Mat1b space(160, 160, std::uint8_t{0});
  for (int x = 10; x < 150; ++x) {
    const double half = x < 80 ? 15 + 0.268 * (80 - x) : 15 + 0.176 * (x - 80);
    for (int y = 0; y < space.rows; ++y) space(y, x) = std::abs(y + 0.5 - 80) < half ? 1 : 0;
  }
  EXPECT_TRUE(mouthsOf(space, 0.05).empty());
}

TEST(Mouths, NoneAboveThreeMetres) {
  EXPECT_FALSE(mouthsOf(neckIntoHall(2.9)).empty());
  EXPECT_TRUE(mouthsOf(neckIntoHall(3.2)).empty());
}

TEST(Mouths, NoneInACorridorOfEvenWidth) {
  EXPECT_TRUE(mouthsOf(DrawnPlan(12, 3).open({0.5, 0.5}, {11.5, 2})).empty());
  DrawnPlan bend = DrawnPlan(8, 8).open({0.5, 0.5}, {7.5, 2}).open({0.5, 0.5}, {2, 7.5});
  EXPECT_TRUE(mouthsOf(bend).empty());
  EXPECT_TRUE(mouthsOf(bend.at(0.05, 30)).empty()) << "turned";
}

TEST(Mouths, NoneWhereAWallStandsBetween) {
  // the neck is walled up where it ends, but for a slit at its side
  const DrawnPlan plan = neckIntoHall(1.5).close({5.3, 3.3}, {5.6, 4.5});
  for (const Opening& mouth : mouthsOf(plan)) EXPECT_LT(mouth.jambs.length(), 20);
}

}  // namespace
}  // namespace agrid
