// SPDX-License-Identifier: BSD-3-Clause
// What AreaMethod::kBorders makes of whole maps.
#include <set>

#include <gtest/gtest.h>

#include "support/drawn_plan.h"
#include "support/segmentation.h"

namespace agrid {
namespace {

using test::DrawnPlan;

AreaMap segment(const OccupancyMap& map) {
  AreaParams params;
  params.method = AreaMethod::kBorders;
  return test::segment(map, {}, params);
}

std::uint16_t labelAt(const OccupancyMap& map, const AreaMap& areas, const Point2& point_px) {
  const Point2 point = point_px * map.geometry().resolution;
  return areas.pixel_labels[map.geometry().index(map.geometry().pixelAt(point).value())];
}

DrawnPlan twoRooms() {
  return DrawnPlan(9.2, 5)
      .open({0.5, 0.5}, {4.5, 4.5})
      .open({4.7, 0.5}, {8.7, 4.5})
      .open({4.4, 2}, {4.8, 2.9});
}

TEST(BordersMethod, TwoRoomsAndADoor) {
  for (const double resolution : {0.025, 0.05, 0.1}) {
    const DrawnPlan plan = twoRooms().at(resolution);
    const OccupancyMap map = plan.map();
    const AreaMap areas = segment(map);
    ASSERT_EQ(areas.areas.size(), 2U) << resolution;
    ASSERT_EQ(areas.doors.size(), 1U) << resolution;
    EXPECT_EQ(areas.doors[0].kind, DoorKind::kDoor);
    EXPECT_NEAR(areas.doors[0].width, 0.9, resolution);
    EXPECT_NEAR(areas.doors[0].jambs_map.midpoint().x(), 4.6, 0.11);
    EXPECT_NEAR(areas.doors[0].jambs_map.midpoint().y(), 2.45, resolution);
    EXPECT_GT(areas.doors[0].confidence, 0.9);
  }
}

TEST(BordersMethod, TurnedRoomsAndADoor) {
  for (const double degrees : {7., 30., 45., 90.}) {
    const DrawnPlan plan = twoRooms().at(0.05, degrees);
    const OccupancyMap map = plan.map();
    const AreaMap areas = segment(map);
    ASSERT_EQ(areas.areas.size(), 2U) << degrees;
    ASSERT_EQ(areas.doors.size(), 1U) << degrees;
    EXPECT_NEAR(areas.doors[0].width, 0.9, 0.1) << degrees;
    EXPECT_LT((areas.doors[0].jambs_map.midpoint() / 0.05 - plan.inImage({4.6, 2.45})).norm(), 3.5);
  }
}

TEST(BordersMethod, ACorridorWithFacingDoorsStaysOne) {
  DrawnPlan plan(15.5, 11.4);
  plan.open({0.5, 4.7}, {15, 6.7});
  for (const double x : {0.5, 5.5, 10.5}) {
    plan.open({x, 0.5}, {x + 4.5, 4.5}).open({x, 6.9}, {x + 4.5, 10.9});
    plan.open({x + 1.8, 4.4}, {x + 2.7, 7});
  }
  const OccupancyMap map = plan.map();
  const AreaMap areas = segment(map);
  EXPECT_EQ(areas.areas.size(), 7U);
  EXPECT_EQ(areas.doors.size(), 6U);
  std::set<std::uint16_t> corridor;
  for (double x = 0.7; x < 14.9; x += 0.1) {
    corridor.insert(labelAt(map, areas, plan.inImage({x, 5.7})));
  }
  EXPECT_EQ(corridor.size(), 1U);
}

TEST(BordersMethod, OpenFrontedRoomsAreAreasOfTheirOwn) {
  // an aisle of 2 m; five rooms of 3 m x 3.5 m, whose fronts are open but for 0.3 m on either side
  DrawnPlan plan(17, 7);
  plan.open({0.5, 0.5}, {16.3, 2.5});
  for (double x = 0.5; x < 16; x += 3.2) {
    plan.open({x, 2.7}, {x + 3, 6.2}).open({x + 0.3, 2.4}, {x + 2.7, 2.8});
  }
  const OccupancyMap map = plan.map();
  const AreaMap areas = segment(map);
  EXPECT_EQ(areas.areas.size(), 6U);
  EXPECT_EQ(areas.doors.size(), 5U);
  std::set<std::uint16_t> rooms;
  for (double x = 0.5; x < 16; x += 3.2) {
    rooms.insert(labelAt(map, areas, plan.inImage({x + 1.5, 4.5})));
  }
  EXPECT_EQ(rooms.size(), 5U);
  EXPECT_EQ(rooms.count(labelAt(map, areas, plan.inImage({8, 1.5}))), 0U);
}

TEST(BordersMethod, ARingCorridorIsOneArea) {
  for (const double width : {1.2, 1.5, 1.8, 2., 2.5, 3.}) {
    DrawnPlan plan(13, 10);
    plan.open({0.5, 0.5}, {12.5, 9.5})
        .close({0.5 + width, 0.5 + width}, {12.5 - width, 9.5 - width});
    const AreaMap areas = segment(plan.map());
    EXPECT_EQ(areas.areas.size(), 1U) << width;
    EXPECT_TRUE(areas.doors.empty()) << width;
  }
}

TEST(BordersMethod, AnEmptyHallIsOneArea) {
  for (const double degrees : {0., 20.}) {
    const DrawnPlan plan = DrawnPlan(21, 13).open({0.5, 0.5}, {20.5, 12.5}).at(0.05, degrees);
    EXPECT_EQ(segment(plan.map()).areas.size(), 1U) << degrees;
  }
}

TEST(BordersMethod, EveryFreePixelOfARoomHasItsArea) {
  const OccupancyMap map = twoRooms().map();
  const AreaMap areas = segment(map);
  double size = 0;
  for (const Area& area : areas.areas) size += area.size;
  EXPECT_NEAR(size, 2 * 16 + 0.2 * 0.9, 1e-6);
}

}  // namespace
}  // namespace agrid
