// SPDX-License-Identifier: BSD-3-Clause
// Areas, doors and tags on maps that are looked at along their walls.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "agrid/areas/area_segmentation.h"
#include "support/drawn_plan.h"

namespace agrid {
namespace {

using test::DrawnPlan;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180;

DrawnPlan twoRooms(double resolution, double degrees) {
  return DrawnPlan(9.2, 5)
      .open({0.5, 0.5}, {4.5, 4.5})
      .open({4.7, 0.5}, {8.7, 4.5})
      .open({4.4, 2}, {4.8, 2.9})
      .at(resolution, degrees);
}

Point2 inMap(const DrawnPlan& plan, const Point2& point) {
  return plan.inImage(point) * plan.resolution();
}

/// A grid along the walls of a plan.
AGrid gridAlong(double degrees) {
  return AGrid({Point2(-20, -20), degrees * kRadPerDeg}, {0, 20, 40, 60}, {0, 20, 40, 60});
}

/// Which side of the wall a point lies on, and whether it is so near the door that it may be
/// either.
int roomOf(const DrawnPlan& plan, const Point2& point_map) {
  const Point2 along = (inMap(plan, {5.6, 2.5}) - inMap(plan, {4.6, 2.5}));
  const double beyond = (point_map - inMap(plan, {4.6, 2.5})).dot(along);
  return std::abs(beyond) < 0.2 ? 0 : beyond < 0 ? 1 : 2;
}

void expectTwoRooms(const OccupancyMap& map, const DrawnPlan& plan, const AreaMap& found) {
  ASSERT_EQ(found.areas.size(), 2U);
  std::array<std::uint16_t, 3> label_of{};
  for (const int room : {1, 2}) {
    const Point2 middle = inMap(plan, {room == 1 ? 2.5 : 6.7, 2.5});
    label_of[static_cast<std::size_t>(room)] =
        found.pixel_labels[map.geometry().index(map.geometry().pixelAt(middle).value())];
  }
  EXPECT_NE(label_of[1], label_of[2]);
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    const Pixel p = map.geometry().pixel(i);
    const int room = roomOf(plan, map.geometry().center(p));
    if (!map.isFree(p)) {
      EXPECT_EQ(found.pixel_labels[i], 0);
    } else if (room > 0) {
      EXPECT_EQ(found.pixel_labels[i], label_of[static_cast<std::size_t>(room)])
          << p.x << ' ' << p.y;
    } else {
      EXPECT_NE(found.pixel_labels[i], 0);
    }
  }
  double size = 0;
  for (const Area& area : found.areas) size += area.size;
  const auto free_px = std::count(map.pixels().begin(), map.pixels().end(), Occupancy::kFree);
  const double resolution = map.geometry().resolution;
  EXPECT_NEAR(size, static_cast<double>(free_px) * resolution * resolution, 1e-6);
}

void expectTheDoor(const DrawnPlan& plan, const AreaMap& found) {
  ASSERT_EQ(found.doors.size(), 1U);
  const Door& door = found.doors[0];
  EXPECT_NEAR(door.width, 0.9, 0.1);
  EXPECT_LT((door.jambs_map.midpoint() - inMap(plan, {4.6, 2.45})).norm(), 0.15);
  const Point2 along = (inMap(plan, {4.6, 3.45}) - inMap(plan, {4.6, 2.45}));
  const Point2 jambs = (door.jambs_map.b - door.jambs_map.a).normalized();
  EXPECT_GT(std::abs(jambs.dot(along)), 0.99) << "along the wall";
}

TEST(AlignedAreas, RoomsAndDoorsAreThoseOfTheMap) {
  for (const double degrees : {0., 7., 30., 41., 90.}) {
    for (const double resolution : {0.025, 0.05}) {
      const DrawnPlan plan = twoRooms(resolution, degrees);
      const OccupancyMap map = plan.map();
      const AreaMap found = findAreas(map, gridAlong(degrees), {}).area_map;
      SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(resolution) + " m");
      expectTwoRooms(map, plan, found);
      expectTheDoor(plan, found);
      EXPECT_GT(found.doors.at(0).confidence, 0.9);
      EXPECT_TRUE(found.warnings.empty());
    }
  }
}

TEST(AlignedAreas, TagsInSightOfAWallAreUsed) {
  const DrawnPlan plan = twoRooms(0.05, 30);
  const OccupancyMap map = plan.map();
  int used = 0;
  for (double x = 0.6; x < 4.4; x += 0.1) {
    AreaTag kitchen;
    kitchen.id = AreaId{7};
    kitchen.name = "kitchen";
    kitchen.seed_map = inMap(plan, {x, 0.53});
    if (!map.isFree(map.geometry().pixelAt(kitchen.seed_map).value())) continue;
    ++used;
    const TaggedAreas found = findAreas(map, gridAlong(30), {kitchen});
    ASSERT_EQ(found.area_map.areas.size(), 2U) << x;
    EXPECT_TRUE(found.area_map.warnings.empty());
    const auto label =
        found.area_map
            .pixel_labels[map.geometry().index(map.geometry().pixelAt(kitchen.seed_map).value())];
    EXPECT_EQ(found.area_map.areas.at(label - 1U).name, "kitchen");
    EXPECT_EQ(std::get<AreaTag>(found.tags.at(0)).seed_map, kitchen.seed_map) << "as it was given";
  }
  EXPECT_GT(used, 20);
}

TEST(AlignedAreas, ADoorTagClosesTheAreasWhereItLies) {
  const DrawnPlan plan = twoRooms(0.05, 30);
  const OccupancyMap map = plan.map();
  DoorTag tag;
  tag.id = DoorId{3};
  tag.source = TagSource::kManual;
  tag.pose_map = {inMap(plan, {2.5, 2.5}), 30 * kRadPerDeg};
  const AreaMap found = findAreas(map, gridAlong(30), {tag}).area_map;
  EXPECT_EQ(found.areas.size(), 3U);
  const auto door = std::find_if(found.doors.begin(), found.doors.end(),
                                 [](const Door& d) { return d.id == DoorId{3}; });
  ASSERT_NE(door, found.doors.end());
  EXPECT_EQ(door->confidence, 1);
  EXPECT_NEAR(door->width, 4, 0.15) << "up to the walls";
  EXPECT_LT((door->jambs_map.midpoint() - inMap(plan, {2.5, 2.5})).norm(), 0.1);
}

TEST(AlignedAreas, BothWaysToThemAgree) {
  const DrawnPlan plan = twoRooms(0.05, 17);
  const OccupancyMap map = plan.map();
  AreaTag seed;
  seed.seed_map = inMap(plan, {6, 0.53});
  std::vector<Tag> tags{seed};
  const TaggedAreas at_once = findAreas(map, gridAlong(17), tags);
  for (Tag& tag : proposeTags(map, tags, {}, 17 * kRadPerDeg)) tags.push_back(std::move(tag));
  const AreaMap in_steps = segmentAreas(map, gridAlong(17), tags);
  EXPECT_EQ(at_once.tags.size(), tags.size());
  EXPECT_EQ(at_once.area_map.pixel_labels, in_steps.pixel_labels);
  EXPECT_EQ(at_once.area_map.doors.size(), in_steps.doors.size());
}

}  // namespace
}  // namespace agrid
