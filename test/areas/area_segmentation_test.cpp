// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_segmentation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/segmentation.h"

namespace agrid {
namespace {

using test::asciiMap;
using test::segment;

OccupancyMap twoRooms() {
  return asciiMap(
      {
          "#################",
          "#.......#.......#",
          "#.......#.......#",
          "#...............#",
          "#...............#",
          "#.......#.......#",
          "#.......#.......#",
          "#.......#.......#",
          "#################",
      },
      0.5);
}

OccupancyMap oneRoom() {
  std::vector<std::string> rows(18, "#....................#");
  rows.front() = rows.back() = "######################";
  return asciiMap(rows, 0.5);
}

AreaTag areaTag(std::uint32_t id, const std::string& name, const Point2& seed) {
  AreaTag tag;
  tag.id = AreaId{id};
  tag.name = name;
  tag.seed_map = seed;
  tag.source = TagSource::kManual;
  return tag;
}

DoorTag doorTag(std::uint32_t id, const std::string& name, const Pose2& pose, double width) {
  DoorTag tag;
  tag.id = DoorId{id};
  tag.name = name;
  tag.pose_map = pose;
  tag.width = width;
  tag.source = TagSource::kManual;
  tag.state = DoorState::kClosed;
  return tag;
}

std::uint16_t labelAt(const OccupancyMap& map, const AreaMap& areas, const Point2& point) {
  return areas.pixel_labels[map.geometry().index(map.geometry().pixelAt(point).value())];
}

TEST(AreaSegmentation, TwoRoomsAndADoorAreTwoAreasAndOneDoor) {
  const OccupancyMap map = twoRooms();
  const AreaMap areas = segment(map);
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(areas.areas[0].name, "area_1");
  EXPECT_EQ(areas.areas[0].source, TagSource::kAutomatic);
  EXPECT_NEAR(areas.areas[0].size + areas.areas[1].size, (7 * 7 * 2 + 2) * 0.25, 1e-9);
  EXPECT_NE(labelAt(map, areas, {1, 1}), labelAt(map, areas, {7, 1}));
  ASSERT_EQ(areas.doors.size(), 1U);
  const Door& door = areas.doors[0];
  EXPECT_EQ(door.id, DoorId{1});
  EXPECT_EQ(door.name, "door_1");
  EXPECT_EQ(door.kind, DoorKind::kDoor);
  EXPECT_EQ(door.state, DoorState::kUnknown);
  EXPECT_EQ(door.areas[0], AreaId{1});
  EXPECT_EQ(door.areas[1], AreaId{2});
  // on the walls' surface: the opening is two pixels of 0.5 m, from y = 2 to y = 3
  EXPECT_DOUBLE_EQ(door.width, 1);
  EXPECT_NEAR(door.jambs_map.a.x(), 4.25, 1e-9);
  EXPECT_NEAR(door.jambs_map.b.x(), 4.25, 1e-9);
  EXPECT_NEAR(std::min(door.jambs_map.a.y(), door.jambs_map.b.y()), 2, 1e-9);
  EXPECT_NEAR(std::max(door.jambs_map.a.y(), door.jambs_map.b.y()), 3, 1e-9);
  EXPECT_GE(door.confidence, 0.9);
  // cells of 1 m, 9 in a row: row 2, column 4; the end lies on the border to row 3
  EXPECT_EQ(door.cells.front(), 2U * 9 + 4);
}

TEST(AreaSegmentation, AnLShapedCorridorIsOneArea) {
  const OccupancyMap map = asciiMap(
      {
          "################",
          "#....###########",
          "#....###########",
          "#....###########",
          "#....###########",
          "#....###########",
          "#..............#",
          "#..............#",
          "#..............#",
          "#..............#",
          "################",
      },
      0.5);
  for (const AreaMethod method :
       {AreaMethod::kBorders, AreaMethod::kPersistence, AreaMethod::kPaper}) {
    AreaParams params;
    params.method = method;
    const AreaMap areas = segment(map, {}, params);
    ASSERT_EQ(areas.areas.size(), 1U);
    EXPECT_TRUE(areas.doors.empty());
    EXPECT_EQ(labelAt(map, areas, areas.areas[0].anchor_map), 1);
    EXPECT_EQ(areas.areas[0].outline_map.size(), 6U);
  }
}

TEST(AreaSegmentation, ARingCorridorIsOneArea) {
  const OccupancyMap map = asciiMap(
      {
          "##############",
          "#............#",
          "#............#",
          "#............#",
          "#...######...#",
          "#...######...#",
          "#...######...#",
          "#............#",
          "#............#",
          "#............#",
          "##############",
      },
      0.5);
  for (const AreaMethod method :
       {AreaMethod::kBorders, AreaMethod::kPersistence, AreaMethod::kPaper}) {
    AreaParams params;
    params.method = method;
    const AreaMap areas = segment(map, {}, params);
    ASSERT_EQ(areas.areas.size(), 1U);
    EXPECT_EQ(labelAt(map, areas, areas.areas[0].anchor_map), 1);
  }
}

TEST(AreaSegmentation, AWideOpeningIsAPassage) {
  std::vector<std::string> rows(20, "#..................#..................#");
  rows.front() = rows.back() = std::string(39, '#');
  for (std::size_t r = 7; r < 13; ++r) rows[r][19] = '.';
  const AreaMap areas = segment(asciiMap(rows, 0.5));
  ASSERT_EQ(areas.areas.size(), 2U);
  ASSERT_EQ(areas.doors.size(), 1U);
  EXPECT_EQ(areas.doors[0].kind, DoorKind::kPassage);
  EXPECT_DOUBLE_EQ(areas.doors[0].width, 3);
}

TEST(AreaSegmentation, AnAreaTagNamesItsArea) {
  const OccupancyMap map = twoRooms();
  AreaTag tag = areaTag(7, "kitchen", {7, 1});
  tag.category = "room";
  tag.properties = {{"floor", "tiles"}};
  const AreaMap areas = segment(map, {tag});
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(areas.areas[0].id, AreaId{1});
  const Area& kitchen = areas.areas[1];
  EXPECT_EQ(kitchen.id, AreaId{7});
  EXPECT_EQ(kitchen.name, "kitchen");
  EXPECT_EQ(kitchen.category, "room");
  EXPECT_EQ(kitchen.properties, tag.properties);
  EXPECT_EQ(kitchen.source, TagSource::kManual);
  EXPECT_EQ(labelAt(map, areas, {7.5, 3.5}), 2);
  EXPECT_EQ(labelAt(map, areas, {1, 1}), 1);
}

TEST(AreaSegmentation, TwoAreaTagsSplitARoomBetweenThem) {
  const OccupancyMap map = oneRoom();
  const AreaMap areas = segment(map, {areaTag(1, "desk", {1.2, 4}), areaTag(2, "sofa", {9.7, 4})});
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(labelAt(map, areas, {5, 4}), 1);
  EXPECT_EQ(labelAt(map, areas, {6, 4}), 2);
  EXPECT_NEAR(areas.areas[0].size, areas.areas[1].size, 1e-9);
  ASSERT_EQ(areas.doors.size(), 1U);
  EXPECT_EQ(areas.doors[0].kind, DoorKind::kPassage);
}

TEST(AreaSegmentation, ThreeAreaTagsInTwoRoomsSplitOnlyTheOneThatHoldsTwo) {
  const OccupancyMap map = twoRooms();
  const AreaMap areas =
      segment(map, {areaTag(1, "a", {1, 1}), areaTag(2, "b", {5, 1}), areaTag(3, "c", {7.5, 3.5})});
  ASSERT_EQ(areas.areas.size(), 3U);
  EXPECT_NEAR(areas.areas[0].size, 49 * 0.25, 0.6);
  EXPECT_NEAR(areas.areas[1].size + areas.areas[2].size, 49 * 0.25, 0.6);
}

TEST(AreaSegmentation, WithoutProposalsAnAreaTakesWhatHasNoTag) {
  const OccupancyMap map = twoRooms();
  const AreaMap areas =
      segmentAreas(map, test::squareGrid(map.geometry(), 1), {areaTag(4, "flat", {1, 1})});
  ASSERT_EQ(areas.areas.size(), 1U);
  EXPECT_TRUE(areas.doors.empty());
  EXPECT_NEAR(areas.areas[0].size, (7 * 7 * 2 + 2) * 0.25, 1e-9);
}

TEST(AreaSegmentation, ADoorTagSplitsARoomUpToTheWalls) {
  const OccupancyMap map = oneRoom();
  for (const double width : {0., 8., 7.6, 20.}) {
    const DoorTag tag = doorTag(5, "curtain", {{6.2, 4.1}, 0}, width);
    const AreaMap areas = segment(map, {tag});
    ASSERT_EQ(areas.areas.size(), 2U) << width;
    ASSERT_EQ(areas.doors.size(), 1U) << width;
    const Door& door = areas.doors[0];
    EXPECT_EQ(door.id, DoorId{5});
    EXPECT_EQ(door.name, "curtain");
    EXPECT_EQ(door.confidence, 1);
    EXPECT_EQ(door.state, DoorState::kClosed);
    EXPECT_EQ(door.source, TagSource::kManual);
    EXPECT_EQ(door.kind, DoorKind::kDoor);
    EXPECT_NEAR(door.width, 8, 1e-9) << width;
    EXPECT_NEAR(door.jambs_map.a.x(), 6.2, 1e-9);
    EXPECT_NE(labelAt(map, areas, {5.7, 1}), labelAt(map, areas, {6.8, 1}));
  }
}

TEST(AreaSegmentation, NothingSlipsThroughASlantedDoorTag) {
  const OccupancyMap map = oneRoom();
  for (int degrees = -180; degrees < 180; degrees += 7) {
    const double yaw = degrees * M_PI / 180;
    const Pose2 pose{{5.4, 4.3}, yaw};
    const AreaMap areas = segment(map, {doorTag(1, "", pose, 0)});
    ASSERT_EQ(areas.areas.size(), 2U) << degrees;
    ASSERT_EQ(areas.doors.size(), 1U) << degrees;
    for (std::size_t i = 0; i < areas.pixel_labels.size(); ++i) {
      const Point2 point = inverse(pose) * map.geometry().center(map.geometry().pixel(i));
      if (areas.pixel_labels[i] == 0 || std::abs(point.x()) < 1) continue;
      const Point2 before = pose * Point2(-1.2, 0);
      const bool is_before = areas.pixel_labels[i] == labelAt(map, areas, before);
      EXPECT_EQ(is_before, point.x() < 0) << degrees;
    }
  }
}

TEST(AreaSegmentation, ADoorTagInADoorwayTakesItsPlace) {
  const AreaMap areas = segment(twoRooms(), {doorTag(9, "entry", {{4.3, 2.4}, 0.1}, 0.9)});
  ASSERT_EQ(areas.areas.size(), 2U);
  ASSERT_EQ(areas.doors.size(), 1U);
  EXPECT_EQ(areas.doors[0].id, DoorId{9});
  EXPECT_EQ(areas.doors[0].areas[0], AreaId{1});
  EXPECT_EQ(areas.doors[0].areas[1], AreaId{2});
}

TEST(AreaSegmentation, AutomaticNumbersAndNamesAvoidGivenOnes) {
  const OccupancyMap map = twoRooms();
  const AreaMap areas = segment(map, {areaTag(1, "area_2", {7, 1})});
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(areas.areas[1].id, AreaId{2});
  EXPECT_NE(areas.areas[1].name, "area_2");
  EXPECT_FALSE(areas.areas[1].name.empty());
}

TEST(AreaSegmentation, TagsThatCannotBeUsedAreWarnedOf) {
  const OccupancyMap map = twoRooms();
  const AreaMap areas =
      segment(map, {areaTag(1, "in the wall", {0.1, 0.1}), areaTag(2, "beyond", {100, 0}),
                    areaTag(3, "nowhere", {std::nan(""), 0}), areaTag(4, "first", {1, 1}),
                    areaTag(5, "same", {1.1, 1.1}), doorTag(6, "walled up", {{0.1, 0.1}, 0}, 1),
                    doorTag(7, "stump", {{2, 2}, 0}, 0.4)});
  ASSERT_EQ(areas.areas.size(), 2U);
  ASSERT_EQ(areas.warnings.size(), 6U);
  for (const char* name : {"in the wall", "beyond", "nowhere", "same", "walled up", "stump"}) {
    EXPECT_EQ(std::count_if(areas.warnings.begin(), areas.warnings.end(),
                            [&](const std::string& w) { return w.find(name) != w.npos; }),
              1)
        << name;
  }
}

TEST(AreaSegmentation, RefusesTwoTagsWithOneId) {
  EXPECT_THROW(segment(twoRooms(), {areaTag(3, "a", {1, 1}), areaTag(3, "b", {7, 1})}),
               std::invalid_argument);
}

}  // namespace
}  // namespace agrid
