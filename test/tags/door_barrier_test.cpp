// SPDX-License-Identifier: BSD-3-Clause
#include "tags/door_barrier.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace agrid {
namespace {

/// A corridor of 10 pixels of 0.1 m along x, between walls of 3 pixels.
class DoorBarrier : public ::testing::Test {
 protected:
  DoorBarrier() : free_space(16, 40, std::uint8_t{1}), geometry{40, 16, 0.1, {}} {
    free_space.rowRange(0, 3) = 0;
    free_space.rowRange(13, 16) = 0;
  }
  std::optional<Barrier> find(const Pose2& pose, double width) const {
    DoorTag tag;
    tag.pose_map = pose;
    tag.width = width;
    return findBarrier(free_space, geometry, tag);
  }
  cv::Mat1b free_space;
  MapGeometry geometry;
};

TEST_F(DoorBarrier, OfNoWidthReachesBothWalls) {
  const auto barrier = find({{2.05, 0.7}, 0}, 0);
  ASSERT_TRUE(barrier);
  EXPECT_NEAR(barrier->jambs_map.a.y(), 0.3, 1e-12);
  EXPECT_NEAR(barrier->jambs_map.b.y(), 1.3, 1e-12);
  EXPECT_NEAR(barrier->jambs_map.a.x(), 2.05, 1e-12);
  EXPECT_EQ(std::set<std::size_t>(barrier->pixels.begin(), barrier->pixels.end()).size(), 10U);
  for (const std::size_t i : barrier->pixels) EXPECT_EQ(i % 40, 20U);
}

TEST_F(DoorBarrier, EndsWhereItsWidthEndsUnlessAWallIsNear) {
  const auto half = find({{2.05, 0.35}, 0}, 0.4);
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->jambs_map.a.y(), 0.3, 1e-12);
  EXPECT_NEAR(half->jambs_map.b.y(), 0.55, 1e-12);
  const auto carried_on = find({{2.05, 0.8}, 0}, 0.5);
  ASSERT_TRUE(carried_on);
  EXPECT_NEAR(carried_on->jambs_map.length(), 1, 1e-12);
}

TEST_F(DoorBarrier, DoesNotPassThroughAWall) {
  const auto barrier = find({{2.05, 0.8}, 0}, 1.6);
  ASSERT_TRUE(barrier);
  EXPECT_NEAR(barrier->jambs_map.length(), 1, 1e-12);
}

TEST_F(DoorBarrier, NeedsItsCentreInFreeSpace) {
  EXPECT_FALSE(find({{2, 0.1}, 0}, 1));
  EXPECT_FALSE(find({{-1, 0.8}, 0}, 1));
  EXPECT_FALSE(find({{std::nan(""), 0.8}, 0}, 1));
}

TEST_F(DoorBarrier, ItsPixelsTouchByTheirSidesAtAnyYaw) {
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const auto barrier = find({{2.03, 0.81}, degrees * M_PI / 180}, 0.9);
    ASSERT_TRUE(barrier);
    const std::set<std::size_t> pixels(barrier->pixels.begin(), barrier->pixels.end());
    std::set<std::size_t> reached{*pixels.begin()};
    std::vector<std::size_t> queue{*pixels.begin()};
    while (!queue.empty()) {
      const std::size_t i = queue.back();
      queue.pop_back();
      for (const std::size_t j : {i + 1, i - 1, i + 40, i - 40}) {
        if (pixels.count(j) > 0 && reached.insert(j).second) queue.push_back(j);
      }
    }
    EXPECT_EQ(reached, pixels) << degrees;
  }
}

TEST_F(DoorBarrier, ClosesItsPixels) {
  const auto barrier = find({{2.05, 0.7}, 0}, 0);
  closeDoors({*barrier}, free_space);
  EXPECT_EQ(cv::countNonZero(free_space.col(20)), 0);
  EXPECT_EQ(cv::countNonZero(free_space.col(19)), 10);
}

}  // namespace
}  // namespace agrid
