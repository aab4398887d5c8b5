// SPDX-License-Identifier: BSD-3-Clause
#include "tags/border_profile.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "support/drawn_plan.h"
#include "support/regions.h"

namespace agrid {
namespace {

using test::DrawnPlan;
using test::Regions;

constexpr double kPixel = 0.05;  // [m]

/// A room of 4 m x 5 m, a wall of 0.2 m with a door of 1 m and, 0.6 m below it, an opening of
/// 1.4 m, and a room of 6 m x 4 m.
DrawnPlan rooms() {
  return DrawnPlan(11.2, 6)
      .open({0.5, 0.5}, {4.5, 5.5})
      .open({4.7, 0.5}, {10.7, 4.5})
      .open({4.4, 2.5}, {4.8, 3.5})
      .open({4.4, 0.5}, {4.8, 1.9});
}

Opening door() {
  Opening opening;
  opening.jambs = {{92, 50}, {92, 70}};
  return opening;
}

int leftOrRight(const Point2& point) { return point.x() < 92 ? 0 : 1; }

/// The door's stretch of the border; the one below comes first.
BorderProfile doorProfile(const Regions& regions) {
  EXPECT_EQ(regions.stretches.size(), 2U);
  return regions.profile(1);
}

TEST(BorderProfile, ADoorIsAsWideAsItsOpening) {
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight, {door()});
  const BorderProfile profile = doorProfile(regions);
  EXPECT_TRUE(profile.is_opening);
  EXPECT_EQ(profile.jambs_px.a, Point2(92, 50));
  EXPECT_EQ(profile.jambs_px.b, Point2(92, 70));
  EXPECT_DOUBLE_EQ(profile.width, 1);
  EXPECT_DOUBLE_EQ(profile.extent, 1);
  EXPECT_NEAR(profile.clearance, 0.5, 1e-6) << "ten pixels from the nearest wall's centre";
}

TEST(BorderProfile, WhereNoOpeningLiesTheNarrowestPlaceCounts) {
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight);
  const BorderProfile profile = doorProfile(regions);
  EXPECT_FALSE(profile.is_opening);
  EXPECT_NEAR(profile.width, 1, kPixel);
  EXPECT_NEAR(profile.jambs_px.midpoint().y(), 60, 1);
}

TEST(BorderProfile, AnOpeningBesideMostOfTheBorderDoesNotCount) {
  Opening elsewhere;
  elsewhere.jambs = {{92, 50}, {92, 58}};
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight, {elsewhere});
  EXPECT_FALSE(doorProfile(regions).is_opening);
}

TEST(BorderProfile, TheSidesAreMeasuredFromTheMiddleOfTheDoor) {
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight, {door()});
  const BorderProfile profile = doorProfile(regions);
  EXPECT_NEAR(profile.sides[0].depth, 4.1, kPixel);
  EXPECT_NEAR(profile.sides[1].depth, 6.1, kPixel);
  for (std::size_t i = 0; i < SideProfile::kDistances.size(); ++i) {
    EXPECT_NEAR(profile.sides[0].widths[i], 5, kPixel) << i;
    EXPECT_NEAR(profile.sides[1].widths[i], 4, kPixel) << i;
  }
}

TEST(BorderProfile, BehindAWallThereIsNoWidth) {
  DrawnPlan plan = rooms();
  const Regions regions(plan.close({2.9, 2}, {3.2, 4}).freeSpace(), kPixel, leftOrRight, {door()});
  const BorderProfile profile = doorProfile(regions);
  EXPECT_NEAR(profile.sides[0].depth, 1.4, kPixel);
  EXPECT_GT(profile.sides[0].widths[2], 0) << "at 1 m";
  EXPECT_EQ(profile.sides[0].widths[3], 0) << "at 1.5 m";
  EXPECT_EQ(profile.sides[0].widths[4], 0) << "2.5 m: free, but hidden";
}

TEST(BorderProfile, WallsAreFollowedBeyondTheJambs) {
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight, {door()});
  const BorderProfile profile = doorProfile(regions);
  EXPECT_NEAR(profile.wall_runs[0], 0.6, kPixel);
  EXPECT_DOUBLE_EQ(profile.wall_runs[1], 4) << "the map's border is wall";
  EXPECT_NEAR(profile.line_runs[0], 0.6, kPixel);
  EXPECT_DOUBLE_EQ(profile.line_runs[1], 8);
}

TEST(BorderProfile, TheLineGoesOnOverOpeningsAlongIt) {
  Opening along;
  along.jambs = {{92, 10}, {92, 38}};
  const Regions row(rooms().freeSpace(), kPixel, leftOrRight, {door(), along});
  EXPECT_DOUBLE_EQ(doorProfile(row).line_runs[0], 8);
  EXPECT_NEAR(doorProfile(row).wall_runs[0], 0.6, kPixel);
  Opening across;
  across.jambs = {{88, 37}, {98, 37}};
  const Regions crossed(rooms().freeSpace(), kPixel, leftOrRight, {door(), across});
  EXPECT_NEAR(doorProfile(crossed).line_runs[0], 0.6, kPixel);
}

TEST(BorderProfile, AJambMayBeAWallAcross) {
  const DrawnPlan straight = rooms();
  const Regions door_in_wall(straight.freeSpace(), kPixel, leftOrRight, {door()});
  EXPECT_FALSE(doorProfile(door_in_wall).is_flat[0]);
  EXPECT_FALSE(doorProfile(door_in_wall).is_flat[1]);

  const DrawnPlan corridor = DrawnPlan(11, 3).open({0.5, 0.5}, {10.5, 2.5});
  const Regions cut(corridor.freeSpace(), kPixel, [](const Point2& p) { return p.x() < 100; });
  ASSERT_EQ(cut.stretches.size(), 1U);
  const BorderProfile profile = cut.profile(0);
  EXPECT_TRUE(profile.is_flat[0]);
  EXPECT_TRUE(profile.is_flat[1]);
  EXPECT_NEAR(profile.width, 2, kPixel);
  EXPECT_NEAR(profile.walls_at_jambs, 0.5, 0.05) << "half of what is around is behind the wall";
}

TEST(BorderProfile, TheEndsOfAWallTakeLittleOfWhatIsAroundThem) {
  const Regions regions(rooms().freeSpace(), kPixel, leftOrRight, {door()});
  EXPECT_NEAR(doorProfile(regions).walls_at_jambs, 40 / 314., 0.03) << "0.2 m x 0.5 m each";
}

TEST(BorderProfile, AMirroredMapMirrorsTheSides) {
  const cv::Mat1b space = rooms().freeSpace();
  cv::Mat1b mirrored;
  cv::flip(space, mirrored, 1);
  const double x = space.cols - 92;
  Opening opening;
  opening.jambs = {{x, 50}, {x, 70}};
  const Regions original(space, kPixel, leftOrRight, {door()});
  const Regions same(mirrored, kPixel, [&](const Point2& p) { return p.x() < x ? 1 : 0; },
                     {opening});
  const Regions swapped(mirrored, kPixel, [&](const Point2& p) { return p.x() < x ? 0 : 1; },
                        {opening});
  const BorderProfile expected = doorProfile(original);
  for (const std::size_t side : {0U, 1U}) {
    const BorderProfile by_number = doorProfile(same);
    const BorderProfile by_place = doorProfile(swapped);
    EXPECT_NEAR(by_number.sides[side].depth, expected.sides[side].depth, kPixel);
    EXPECT_NEAR(by_place.sides[1 - side].depth, expected.sides[side].depth, kPixel);
    for (std::size_t i = 0; i < SideProfile::kDistances.size(); ++i) {
      EXPECT_NEAR(by_number.sides[side].widths[i], expected.sides[side].widths[i], kPixel);
      EXPECT_NEAR(by_place.sides[1 - side].widths[i], expected.sides[side].widths[i], kPixel);
    }
    EXPECT_NEAR(by_number.wall_runs[side], expected.wall_runs[side], kPixel);
  }
}

TEST(BorderProfile, BordersOfASinglePointHaveOneToo) {
  const DrawnPlan plan = DrawnPlan(2, 1).open({0.2, 0.5}, {1.8, 0.55});
  const Regions regions(plan.freeSpace(), kPixel, [](const Point2& p) { return p.x() < 20; });
  ASSERT_EQ(regions.stretches.size(), 1U);
  const BorderProfile profile = regions.profile(0);
  EXPECT_NEAR(profile.width, kPixel, 1e-9);
  EXPECT_NEAR(profile.sides[0].depth + profile.sides[1].depth, 1.6, 2 * kPixel);
}

}  // namespace
}  // namespace agrid
