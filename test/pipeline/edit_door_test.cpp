// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "agrid/pipeline/edit.h"
#include "support/edited_map.h"

namespace agrid {
namespace {

using test::areaAt;
using test::doorAt;
using test::EditedMap;
using test::expectKnown;
using test::expectRefused;

std::uint32_t number(DoorId id) { return static_cast<std::uint32_t>(id); }

const DoorTag& onlyDoor(const EditedMap& map) { return map.known().doors.at(0); }

TEST(EditDoor, ATagNamesTheDoorThatIsMeantAndKeepsItsIdAndPlace) {
  EditedMap map;
  const DoorTag before = onlyDoor(map);
  EXPECT_NEAR(before.pose_map.position.x(), 4.375, 0.13);
  for (const Point2& point : {Point2(4.1, 2.7), Point2(5.1, 2.2), Point2(4.4, 3.6)}) {
    EditedMap fresh;
    const Edit edit = fresh.edit(doorAt({point, 0.3}, "front"));
    EXPECT_EQ(edit.id, number(before.id));
    ASSERT_EQ(fresh.known().doors.size(), 1U);
    EXPECT_EQ(onlyDoor(fresh).name, "front");
    EXPECT_EQ(onlyDoor(fresh).source, TagSource::kManual);
    EXPECT_EQ(onlyDoor(fresh).pose_map.position, before.pose_map.position);
    EXPECT_EQ(onlyDoor(fresh).width, before.width);
    EXPECT_EQ(fresh.map().area_map.areas.size(), 2U);
  }
}

TEST(EditDoor, ADoorThatLeadsAnotherWayIsNotMeant) {
  EditedMap map;
  expectRefused(EditErrorCode::kInvalid, "no passage", doorAt({{4, 2.7}, M_PI / 2}), map);
}

TEST(EditDoor, AForcedTagPartsTheAreaAndTakingItBackJoinsItAgain) {
  EditedMap map;
  AddTag request = doorAt({{2.4, 2.6}, 0}, "new");
  request.force = true;
  const Edit edit = map.edit(request);
  EXPECT_EQ(map.map().area_map.areas.size(), 3U);
  EXPECT_EQ(findTag(map.known(), DoorId{edit.id})->pose_map.position, Point2(2.4, 2.6));
  expectKnown(edit.id, request, map);
  map.edit(RemoveTag{TagKind::kDoor, edit.id});
  EXPECT_EQ(map.map().area_map.areas.size(), 2U);
  EXPECT_EQ(findTag(map.known(), DoorId{edit.id}), nullptr);
}

/// A corridor of 8 x 1.5 m along x at y = 0.8 with jambs at x = 4.075 that leave 1.1 m.
EditedMap corridor() {
  std::vector<std::string> rows(32, "#" + std::string(160, '.') + "#");
  for (const std::size_t y : {1U, 2U, 3U, 4U, 27U, 28U, 29U, 30U}) rows[y].replace(80, 3, "###");
  rows.front() = rows.back() = std::string(162, '#');
  return EditedMap(test::annotated(test::asciiGrid(rows, 0.05)));
}

TEST(EditDoor, WhereNoDoorIsTheNarrowestPlaceNearbyIsMeant) {
  EditedMap map = corridor();
  ASSERT_TRUE(map.known().doors.empty());
  const Edit edit = map.edit(doorAt({{3.6, 0.9}, 0.2}, "fire door"));
  const DoorTag* door = findTag(map.known(), DoorId{edit.id});
  ASSERT_NE(door, nullptr);
  EXPECT_LT((door->pose_map.position - Point2(4.075, 0.8)).norm(), 0.026);
  EXPECT_NEAR(door->pose_map.yaw, 0, 1e-6);
  EXPECT_NEAR(door->width, 1.1, 1e-6);
  EXPECT_EQ(map.map().area_map.areas.size(), 2U);
  expectKnown(edit.id, doorAt({{3.6, 0.9}, 0.2}, "fire door"), map);
  expectKnown(edit.id, doorAt({{4.3, 0.7}, 3}, "Fire Door"), map);
  // and taking it back leaves nothing
  map.edit(RemoveTag{TagKind::kDoor, edit.id});
  EXPECT_TRUE(map.known().doors.empty());
  EXPECT_EQ(map.map().area_map.areas.size(), 1U);
}

TEST(EditDoor, APlaceBetweenWallsIsMeantRatherThanADoorFartherAway) {
  EditedMap map = corridor();
  const std::uint32_t far = map.edit(doorAt({{3.2, 0.8}, 0}, "far")).id;
  AddTag moved = doorAt({{3.15, 0.8}, 0}, "far");
  moved.force = moved.replace = true;
  map.edit(moved);
  EXPECT_EQ(findTag(map.known(), DoorId{far})->pose_map.position, Point2(3.15, 0.8));
  const Edit near = map.edit(doorAt({{4, 0.8}, 0}, "near"));
  EXPECT_NE(near.id, far);
  EXPECT_LT((findTag(map.known(), DoorId{near.id})->pose_map.position - Point2(4.075, 0.8)).norm(),
            0.026);
  EXPECT_EQ(map.map().area_map.areas.size(), 3U);
}

TEST(EditDoor, AForcedDoorOnABorderNamesIt) {
  EditedMap map;
  const DoorTag before = onlyDoor(map);
  AddTag request = doorAt({before.pose_map.position + Point2(0.08, 0.05), 0.1}, "front");
  request.force = true;
  EXPECT_EQ(map.edit(request).id, number(before.id));
  EXPECT_EQ(onlyDoor(map).pose_map.position, before.pose_map.position);
  expectKnown(number(before.id), request, map);
}

TEST(EditDoor, ARemovedDoorIsAbsentAndComesBackUnderItsId) {
  EditedMap map;
  map.edit(areaAt({2, 2}, "kitchen"));
  map.edit(areaAt({6, 2}, "hall"));
  const DoorId id = onlyDoor(map).id;
  const Edit removal = map.edit(RemoveTag{TagKind::kDoor, number(id)});
  EXPECT_NE(removal.message.find("kitchen"), std::string::npos);
  EXPECT_NE(removal.message.find("waits"), std::string::npos);
  EXPECT_TRUE(findTag(map.known(), id)->absent);
  EXPECT_EQ(map.map().area_map.areas.size(), 1U);
  EXPECT_EQ(map.known().pending.size(), 1U);
  const Edit back = map.edit(doorAt({{4.4, 2.5}, 0}, "front"));
  EXPECT_EQ(back.id, number(id));
  EXPECT_FALSE(findTag(map.known(), id)->absent);
  EXPECT_EQ(map.known().doors.size(), 1U);
  EXPECT_EQ(map.map().area_map.areas.size(), 2U);
  expectKnown(back.id, doorAt({{4.4, 2.5}, 0}, "front"), map);
}

TEST(EditDoor, ADoorIsRenamedClosedAndMoved) {
  EditedMap map;
  const DoorId id = onlyDoor(map).id;
  AddTag rename = doorAt({}, "exit");
  rename.placement = Placement::kUnchanged;
  std::get<DoorTag>(rename.tag).id = id;
  map.edit(rename);
  EXPECT_EQ(onlyDoor(map).name, "exit");
  const Edit closed = map.edit(SetDoor{id, DoorState::kClosed, TagSource::kInteraction});
  EXPECT_EQ(closed.id, number(id));
  EXPECT_EQ(onlyDoor(map).state, DoorState::kClosed);
  EXPECT_EQ(onlyDoor(map).source, TagSource::kInteraction);
  EXPECT_EQ(map.map().area_map.doors.at(0).state, DoorState::kClosed);
  AddTag moved = doorAt({{2, 2.5}, 0}, "exit");
  moved.force = true;
  expectRefused(EditErrorCode::kNameTaken, "replace", moved, map);
  moved.replace = true;
  EXPECT_EQ(map.edit(moved).id, number(id));
  EXPECT_EQ(findTag(map.known(), id)->pose_map.position, Point2(2, 2.5));
  EXPECT_EQ(findTag(map.known(), id)->state, DoorState::kClosed);
  EXPECT_EQ(map.known().doors.size(), 2U);  // the other border has a door of its own now
  EXPECT_EQ(map.map().area_map.areas.size(), 3U);
}

TEST(EditDoor, T3_InUnknownSpaceADoorIsRefused) {
  EditedMap map;
  AddTag request = doorAt({{9.6, 2.5}, 0}, "lab");
  expectRefused(EditErrorCode::kOutside, "unknown space", request, map);
  request.force = true;
  expectRefused(EditErrorCode::kOutside, "unknown space", request, map);
}

TEST(EditDoor, T4_ADoorInAnObstacleIsAccepted) {
  EditedMap map;
  const AddTag request = doorAt({{0.1, 2.5}, 0}, "back door");
  const Edit edit = map.edit(request);
  ASSERT_NE(findTag(map.known(), DoorId{edit.id}), nullptr);
  EXPECT_EQ(findTag(map.known(), DoorId{edit.id})->pose_map.position, Point2(0.1, 2.5));
  EXPECT_NE(edit.message.find("obstacle"), std::string::npos);
  expectKnown(edit.id, request, map);
  map.edit(RemoveTag{TagKind::kDoor, edit.id});
  EXPECT_EQ(findTag(map.known(), DoorId{edit.id}), nullptr);
}

TEST(EditDoor, T7_TwoNamesForOneDoorAreRefused) {
  EditedMap map;
  const std::uint32_t id = map.edit(doorAt({{4.4, 2.5}, 0}, "front")).id;
  AddTag other = doorAt({{4.2, 2.4}, 0}, "back");
  expectRefused(EditErrorCode::kNameTaken, "'front'", other, map);
  other.replace = true;
  EXPECT_EQ(map.edit(other).id, id);
  EXPECT_EQ(onlyDoor(map).name, "back");
}

TEST(EditDoor, T11_FarFromAnyPassageADoorIsRefusedUnlessForced) {
  EditedMap map;
  AddTag request = doorAt({{2.4, 2.5}, 0}, "new");
  expectRefused(EditErrorCode::kInvalid, "within 1.00 m", request, map);
  expectRefused(EditErrorCode::kInvalid, "1.98 m away", request, map);
  EditParams params;
  params.door_snap_dist = 2;
  EXPECT_EQ(EditedMap().edit(request, params).id, number(onlyDoor(map).id));
  request.force = true;
  const Edit edit = map.edit(request);
  EXPECT_EQ(findTag(map.known(), DoorId{edit.id})->pose_map.position, Point2(2.4, 2.5));
  EXPECT_EQ(map.map().area_map.areas.size(), 3U);
}

TEST(EditDoor, T12_AWidthThatCannotBeIsRefused) {
  EditedMap map;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double width :
       {-0.1, -1e9, 11., 1e308, kNan, std::numeric_limits<double>::infinity()}) {
    AddTag request = doorAt({{4.4, 2.5}, 0});
    std::get<DoorTag>(request.tag).width = width;
    expectRefused(EditErrorCode::kInvalid, "width must lie in [0, 10.96] m", request, map);
  }
  AddTag request = doorAt({{4.4, 2.5}, 0});
  std::get<DoorTag>(request.tag).width = 10.9;
  EXPECT_TRUE(map.edit(request).changed());
}

TEST(EditDoor, ParametersThatMakeNoSenseAreRefused) {
  const EditedMap map;
  const SetDoor request{DoorId{1}, DoorState::kOpen};
  for (const double bad : {0., -1., 5.1, std::numeric_limits<double>::quiet_NaN()}) {
    EditParams params;
    params.door_snap_dist = bad;
    EXPECT_THROW(decide(request, map.map(), params), std::invalid_argument);
  }
  EditParams params;
  params.max_door_width = 11;
  EXPECT_THROW(decide(request, map.map(), params), std::invalid_argument);
  params = {};
  params.max_clutter_diagonal = -1;
  EXPECT_THROW(decide(request, map.map(), params), std::invalid_argument);
}

}  // namespace
}  // namespace agrid
