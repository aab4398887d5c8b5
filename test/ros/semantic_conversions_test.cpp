// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "agrid_map_ros/conversions.h"
#include "two_rooms.h"

namespace agrid_map_ros {
namespace {

const agrid::Pose2 kPlace{{3, -2}, 0.5};

Stamp stamp() {
  Stamp s;
  s.header.frame_id = "world";
  s.header.stamp = ros::Time(12, 34);
  s.version = 6;
  return s;
}

TEST(Conversions, PoseThereAndBack) {
  for (const double yaw : {0.0, 1.0, -3.0, M_PI}) {
    const agrid::Pose2 back = fromMsg(toMsg(agrid::Pose2{{1, 2}, yaw}));
    EXPECT_EQ(back.position, agrid::Point2(1, 2));
    EXPECT_NEAR(std::remainder(back.yaw - yaw, 2 * M_PI), 0, 1e-12);
  }
}

TEST(Conversions, HeadingOfATiltedPoseIsThatOfItsXAxis) {
  geometry_msgs::Pose pose;  // half a turn about the diagonal swaps x and y
  pose.orientation.x = pose.orientation.y = std::sqrt(0.5);
  EXPECT_NEAR(fromMsg(pose).yaw, M_PI / 2, 1e-12);
}

TEST(Conversions, GridThereAndBack) {
  const agrid::SemanticMap map = test::twoRooms(kPlace);
  const agrid_map::AGrid msg = gridToMsg(map, stamp());
  EXPECT_EQ(msg.header.frame_id, "world");
  EXPECT_EQ(msg.header.stamp, ros::Time(12, 34));
  EXPECT_EQ(msg.version, 6U);
  EXPECT_EQ(msg.map_id, map.map().digest());
  const agrid::AGrid back = fromMsg(msg);
  EXPECT_EQ(back.x(), map.grid().x());
  EXPECT_EQ(back.y(), map.grid().y());
  EXPECT_NEAR(back.mapFromGrid().yaw, 0.5, 1e-12);
  ASSERT_EQ(msg.labels.size(), back.cellCount());
  EXPECT_EQ(msg.labels[0], std::uint32_t{agrid_map::AGrid::NONE});
  EXPECT_EQ(msg.labels[5], 3U);
  EXPECT_EQ(msg.labels[7], 7U);
}

TEST(Conversions, GridThatIsNoneIsRefused) {
  agrid_map::AGrid msg;
  msg.x = {0, 1, 1};
  msg.y = {0, 1};
  EXPECT_THROW(fromMsg(msg), std::invalid_argument);
}

TEST(Conversions, OccupancyIsTheShareOfOccupiedPixels) {
  const agrid_map::AGrid msg = gridToMsg(test::twoRooms(kPlace), stamp());
  ASSERT_EQ(msg.occupancy.size(), 12U);
  EXPECT_EQ(msg.occupancy[0], 100);
  EXPECT_EQ(msg.occupancy[5], 0);
  EXPECT_EQ(msg.occupancy[6], 67);  // wall, door, wall
  EXPECT_EQ(msg.occupancy[7], 17);  // 2 of 12, and one unknown
}

TEST(Conversions, OccupancyOfUnknownCells) {
  agrid::SemanticMap map = test::twoRooms();
  map.structure.map =
      std::make_shared<const agrid::OccupancyMap>(agrid::test::asciiMap({"?#", "??"}));
  map.structure.grid = std::make_shared<const agrid::AGrid>(
      agrid::Pose2{}, std::vector<double>{0, 1, 2, 3}, std::vector<double>{0, 2});
  map.area_map.cell_areas.resize(3);
  const std::vector<std::int8_t> expected = {-1, 50, -1};
  EXPECT_EQ(gridToMsg(map, stamp()).occupancy, expected);
}

TEST(Conversions, AreaThereAndBack) {
  agrid::Area area = test::twoRooms().area_map.areas[0];
  area.properties = {{"floor", "2"}, {"alias", "lobby"}};
  area.source = agrid::TagSource::kInteraction;
  area.category_guess = "hall";
  const agrid::Area back = fromMsg(toMsg(area));
  EXPECT_EQ(back.id, area.id);
  EXPECT_EQ(back.name, area.name);
  EXPECT_EQ(back.category, area.category);
  EXPECT_EQ(back.category_guess, "hall");
  EXPECT_EQ(back.anchor_map, area.anchor_map);
  EXPECT_EQ(back.outline_map, area.outline_map);
  EXPECT_EQ(back.size, area.size);
  EXPECT_EQ(back.source, area.source);
  EXPECT_EQ(back.properties, area.properties);
}

TEST(Conversions, DoorThereAndBack) {
  agrid::Door door = test::twoRooms().area_map.doors[0];
  door.kind = agrid::DoorKind::kPassage;
  door.state = agrid::DoorState::kClosed;
  const agrid::Door back = fromMsg(toMsg(door));
  EXPECT_EQ(back.id, door.id);
  EXPECT_EQ(back.name, door.name);
  EXPECT_EQ(back.kind, door.kind);
  EXPECT_EQ(back.jambs_map.a, door.jambs_map.a);
  EXPECT_EQ(back.jambs_map.b, door.jambs_map.b);
  EXPECT_EQ(back.areas, door.areas);
  EXPECT_EQ(back.state, door.state);
  EXPECT_EQ(back.confidence, door.confidence);
  EXPECT_EQ(back.cells, door.cells);
  agrid_map::Door bad = toMsg(door);
  bad.state = 3;
  EXPECT_THROW(fromMsg(bad), std::invalid_argument);
}

TEST(Conversions, EnumeratorsAreTheMessagesConstants) {
  EXPECT_EQ(static_cast<int>(agrid::DoorKind::kPassage), agrid_map::Door::PASSAGE);
  EXPECT_EQ(static_cast<int>(agrid::DoorState::kClosed), agrid_map::Door::CLOSED);
  EXPECT_EQ(static_cast<int>(agrid::TagSource::kInteraction), agrid_map::Tag::INTERACTION);
}

TEST(Conversions, GraphHoldsAreasDoorsAndObjects) {
  const agrid_map::TopologicalGraph graph = graphToMsg(test::twoRooms(), stamp());
  ASSERT_EQ(graph.areas.size(), 2U);
  ASSERT_EQ(graph.doors.size(), 1U);
  EXPECT_EQ(graph.doors[0].areas[0], graph.areas[0].id);
  EXPECT_EQ(graph.doors[0].areas[1], graph.areas[1].id);
  ASSERT_EQ(graph.objects.size(), 1U);
  EXPECT_EQ(graph.objects[0].area, 7U);
  EXPECT_EQ(graph.objects[0].cells, std::vector<std::uint32_t>{7});
  EXPECT_EQ(graph.version, 6U);
}

TEST(Conversions, AreasGridHasAColourClassForEachArea) {
  agrid::SemanticMap map = test::twoRooms();
  map.area_map.areas[1].id = agrid::AreaId{99};
  const nav_msgs::OccupancyGrid msg = areasToMsg(map, stamp().header);
  EXPECT_EQ(msg.data[0], -1);
  EXPECT_EQ(msg.data[9 + 1], 1 + 3);
  EXPECT_EQ(msg.data[9 + 6], 1);  // 1 + 99 mod 99
  EXPECT_EQ(msg.info.width, 9U);
}

TEST(Conversions, XOfADoorTagLeadsThroughTheDoor) {
  const agrid::SemanticMap map = test::twoRooms();
  const agrid_map::Tag tag = tagOf(map.area_map.doors[0], stamp().header);
  EXPECT_EQ(tag.type, agrid_map::Tag::DOOR);
  EXPECT_NEAR(std::abs(std::cos(fromMsg(tag.pose).yaw)), 1, 1e-12);
  EXPECT_EQ(tag.pose.position.x, 4.5);
  EXPECT_EQ(tag.pose.position.y, 2.5);
  EXPECT_EQ(tag.size.y, 1);
}

TEST(Conversions, AreaTagLiesInsideItsArea) {
  const agrid::SemanticMap map = test::twoRooms(kPlace);
  const agrid_map::Tag tag = tagOf(map.area_map.areas[1], stamp().header);
  EXPECT_EQ(tag.type, agrid_map::Tag::AREA);
  EXPECT_EQ(tag.name, "Kitchen");
  const agrid::Area* area = agrid::areaAt(map, fromMsg(tag.pose).position);
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->name, "Kitchen");
}

TEST(Conversions, RouteNamesIdsInOrder) {
  const agrid::SemanticMap map = test::twoRooms();
  const agrid_map::Route route = toMsg(agrid::Route{{1, 0}, {0}, 4.5}, map.area_map);
  EXPECT_EQ(route.areas, (std::vector<std::uint32_t>{7, 3}));
  EXPECT_EQ(route.names, (std::vector<std::string>{"Kitchen", "hall"}));
  EXPECT_EQ(route.doors, std::vector<std::uint32_t>{5});
  EXPECT_EQ(route.length, 4.5);
}

TEST(Conversions, PathIsInTheMapsFrame) {
  const nav_msgs::Path path = pathToMsg({{{1, 2}, 0.5}, {{3, 4}, -0.5}}, stamp().header);
  EXPECT_EQ(path.header.frame_id, "world");
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_EQ(path.poses[1].header.frame_id, "world");
  EXPECT_EQ(path.poses[1].pose.position.y, 4);
  EXPECT_NEAR(fromMsg(path.poses[1].pose).yaw, -0.5, 1e-12);
}

TEST(Conversions, StatusOfAPlanIsPrintable) {
  agrid::Plan plan;
  plan.status = agrid::PlanStatus::kNoRoute;
  plan.message = "door 'a\x1b[2J' is closed";
  const agrid_map::Status status = statusOf(plan.status, plan.message);
  EXPECT_EQ(status.code, std::uint8_t{agrid_map::Status::NO_ROUTE});
  EXPECT_EQ(status.message, "door 'a\\x1b[2J' is closed");
}

}  // namespace
}  // namespace agrid_map_ros
