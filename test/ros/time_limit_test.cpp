// SPDX-License-Identifier: BSD-3-Clause
#include "ros/time_limit.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

TEST(TimeLimit, P10_ZeroIsTheParameterAndWaitingCounts) {
  EXPECT_LE(TimeLimit(0, 50, {}).left(), 50);
  EXPECT_GT(TimeLimit(0, 50, {}).left(), 40);
  EXPECT_LE(TimeLimit(30, 50, {}).left(), 30);
  EXPECT_LE(TimeLimit(0, 50, seconds(20)).left(), 30);
  EXPECT_FALSE(TimeLimit(0, 50, seconds(20)).isOver());
  EXPECT_NO_THROW(TimeLimit(0, 50, seconds(20)).requireTime());
}

TEST(TimeLimit, P10_WhenItIsOverThePlannerStillGetsATimeItCanTake) {
  const TimeLimit limit(1, 50, seconds(2));
  EXPECT_TRUE(limit.isOver());
  EXPECT_GT(limit.left(), 0);
  EXPECT_LT(limit.left(), 1e-6);
  try {
    limit.requireTime();
    ADD_FAILURE();
  } catch (const RequestError& error) {
    EXPECT_EQ(error.code(), int{agrid_map::Status::TIMEOUT});
    EXPECT_STREQ(error.what(), "no answer within 1 s");
  }
}

TEST(TimeLimit, P10_TimeoutsOutOfTheirBoundsAreLeftForThePlannerToRefuse) {
  for (const double bad : {-1.0, 60.001, 1e9, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(TimeLimit(bad, 5, {}).left(), bad);
    EXPECT_FALSE(TimeLimit(bad, 5, {}).isOver());
  }
  EXPECT_TRUE(std::isnan(TimeLimit(std::nan(""), 5, {}).left()));
  EXPECT_TRUE(TimeLimit(-1, 5, hours(1)).isOver());
}

}  // namespace
}  // namespace agrid_map_ros
