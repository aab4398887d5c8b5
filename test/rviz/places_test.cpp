// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <cmath>

#include <gtest/gtest.h>

namespace agrid_map_rviz {
namespace {

using agrid_map::Tag;
using AddTag = agrid_map::AddTag::Request;
using RemoveTag = agrid_map::RemoveTag::Request;
using SetDoor = agrid_map::SetDoor::Request;

/// Areas 1 (automatic), 2 (given, 'hall') and 3; doors 7 and 8 between 1 and 2, 9 between 2 and 3.
agrid_map::TopologicalGraph graph() {
  agrid_map::TopologicalGraph graph;
  graph.header.frame_id = "map";
  for (const std::uint32_t id : {1U, 2U, 3U}) {
    agrid_map::Area area;
    area.id = id;
    area.name = id == 2 ? "hall" : "area_" + std::to_string(id);
    area.source = id == 2 ? Tag::MANUAL : Tag::AUTOMATIC;
    area.anchor.x = id;
    graph.areas.push_back(area);
  }
  for (const std::uint32_t id : {7U, 8U, 9U}) {
    agrid_map::Door door;
    door.id = id;
    door.name = "door_" + std::to_string(id);
    door.areas = {id == 9 ? 3U : 1U, 2U};
    door.jambs[0].x = door.jambs[1].x = id;
    door.jambs[1].y = 2;
    graph.doors.push_back(door);
  }
  return graph;
}

TEST(Places, ADoorLeadsAcrossTheLineBetweenItsJambs) {
  geometry_msgs::Point a, b;
  a.x = 1;
  b.x = 3;
  b.y = 2;
  const AddTag request = doorBetween("map", a, b);
  EXPECT_DOUBLE_EQ(request.tag.pose.position.x, 2);
  EXPECT_DOUBLE_EQ(request.tag.pose.position.y, 1);
  EXPECT_DOUBLE_EQ(request.tag.size.y, std::sqrt(8));
  const auto& q = request.tag.pose.orientation;
  const double yaw = 2 * std::atan2(q.z, q.w);
  EXPECT_NEAR(std::cos(yaw) * (b.x - a.x) + std::sin(yaw) * (b.y - a.y), 0, 1e-12);
}

TEST(Places, JoiningTakesAwayEveryDoorBetweenTwoAreas) {
  const auto changes = joining(graph(), 2, 1);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(std::get<RemoveTag>(changes[0]).id, 7U);
  EXPECT_EQ(std::get<RemoveTag>(changes[1]).id, 8U);
  EXPECT_TRUE(joining(graph(), 1, 3).empty());
}

TEST(Places, UndoOfANewThingRemovesIt) {
  const auto inverse = inverseOf(graph(), tagAt(Tag::OBJECT, "map", 1, 1), 42);
  ASSERT_EQ(inverse.size(), 1U);
  EXPECT_EQ(std::get<RemoveTag>(inverse[0]).id, 42U);
  EXPECT_EQ(std::get<RemoveTag>(inverse[0]).type, Tag::OBJECT);
}

TEST(Places, UndoGivesANamedAreaItsFormerName) {
  const auto inverse = inverseOf(graph(), rename({Tag::AREA, 2}, "lobby"), 2);
  ASSERT_EQ(inverse.size(), 1U);
  EXPECT_EQ(std::get<AddTag>(inverse[0]).tag.id, 2U);
  EXPECT_EQ(std::get<AddTag>(inverse[0]).tag.name, "hall");
}

TEST(Places, UndoTakesBackWhatWasSaidOfAnAutomaticArea) {
  const auto inverse = inverseOf(graph(), rename({Tag::AREA, 1}, "lobby"), 1);
  ASSERT_EQ(inverse.size(), 1U);
  EXPECT_EQ(std::get<RemoveTag>(inverse[0]).id, 1U);
}

TEST(Places, UndoOfAFirstCategoryKeepsTheName) {
  const auto inverse = inverseOf(graph(), setCategory({Tag::AREA, 2}, "corridor"), 2);
  ASSERT_EQ(inverse.size(), 2U);
  EXPECT_EQ(std::get<RemoveTag>(inverse[0]).id, 2U);
  const Tag& again = std::get<AddTag>(inverse[1]).tag;
  EXPECT_EQ(again.name, "hall");
  EXPECT_EQ(again.category, "");
  EXPECT_DOUBLE_EQ(again.pose.position.x, 2);
}

TEST(Places, UndoOfADoorsRemovalPutsItBetweenItsJambs) {
  auto before = graph();
  before.doors[0].source = Tag::MANUAL;
  before.doors[0].state = agrid_map::Door::CLOSED;
  const auto inverse = inverseOf(before, removal({Tag::DOOR, 7}), 0);
  ASSERT_EQ(inverse.size(), 2U);
  const AddTag& again = std::get<AddTag>(inverse[0]);
  EXPECT_TRUE(again.force);
  EXPECT_EQ(again.tag.name, "door_7");
  EXPECT_DOUBLE_EQ(again.tag.pose.position.y, 1);
  EXPECT_DOUBLE_EQ(again.tag.size.y, 2);
  EXPECT_EQ(std::get<SetDoor>(inverse[1]).state, agrid_map::Door::CLOSED);
}

TEST(Places, UndoOfADoorsStateGivesTheFormerOne) {
  auto before = graph();
  before.doors[2].state = agrid_map::Door::OPEN;
  const auto inverse = inverseOf(before, setDoorState(9, agrid_map::Door::CLOSED), 0);
  ASSERT_EQ(inverse.size(), 1U);
  EXPECT_EQ(std::get<SetDoor>(inverse[0]).door, "9");
  EXPECT_EQ(std::get<SetDoor>(inverse[0]).state, agrid_map::Door::OPEN);
}

TEST(Places, WhatChangesNothingHasNoInverse) {
  EXPECT_TRUE(inverseOf(graph(), removal({Tag::AREA, 1}), 0).empty());
  EXPECT_TRUE(inverseOf(graph(), removal({Tag::OBJECT, 5}), 0).empty());
  EXPECT_TRUE(inverseOf(graph(), setDoorState(99, agrid_map::Door::OPEN), 0).empty());
}

}  // namespace
}  // namespace agrid_map_rviz
