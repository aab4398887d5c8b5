// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/identity/recognition.h"

#include <gtest/gtest.h>

#include "identity/drawn_areas.h"

namespace agrid {
namespace {

using test::addDoor;
using test::drawnAreas;
using Rows = std::vector<std::string>;

/// Two rooms of 2.5 m by 2 m with a door of 1 m between them, pixels of 0.5 m.
SemanticMap twoRooms(const Pose2& map_from_image = {}) {
  SemanticMap map = drawnAreas({"#aaaaa#bbbbb#",  //
                                "#aaaaaabbbbb#",  //
                                "#aaaaaabbbbb#",  //
                                "#aaaaa#bbbbb#"},
                               0.5, map_from_image);
  addDoor(map, {map_from_image * Point2(3.25, 0.5), map_from_image * Point2(3.25, 1.5)}, AreaId{1},
          AreaId{2});
  return map;
}

Knowledge first(const SemanticMap& map) { return recognise({}, "", map, "map").knowledge; }

Recognition next(const Knowledge& known, const SemanticMap& map) {
  return recognise(known, "map", map, "map");
}

template <typename T>
T& given(T& tag, const std::string& name) {
  tag.name = name;
  tag.source = TagSource::kManual;
  return tag;
}

ObjectTag fridge(const Point2& position) {
  ObjectTag tag;
  tag.id = ObjectId{1};
  tag.name = "fridge";
  tag.pose_map.position = position;
  return tag;
}

TEST(Recognition, ADoorOfTheFirstMapIsATagAcrossItsJambs) {
  const Knowledge known = first(twoRooms());
  ASSERT_EQ(known.doors.size(), 1U);
  EXPECT_EQ(known.doors[0].name, "door_1");
  EXPECT_NEAR((known.doors[0].pose_map.position - Point2(3.25, 1)).norm(), 0, 1e-9);
  EXPECT_NEAR(std::abs(std::sin(known.doors[0].pose_map.yaw)), 0, 1e-9);
  EXPECT_NEAR(known.doors[0].width, 1, 1e-9);
}

TEST(Recognition, TheSameMapChangesNothing) {
  Knowledge known = first(twoRooms());
  known.doors[0].state = DoorState::kClosed;
  apply(PutTag{fridge({1, 1})}, known);
  const Recognition found = next(known, twoRooms());
  EXPECT_TRUE(difference(known, found.knowledge).empty());
  EXPECT_TRUE(found.report.empty());
}

TEST(Recognition, ADoorThatMovedALittleKeepsWhatIsKnownOfIt) {
  Knowledge known = first(twoRooms());
  known.doors[0].state = DoorState::kClosed;
  known.doors[0].properties["cost"] = "3";
  known.doors[0].pose_map.yaw += 3.14159265358979323846;
  const Recognition found = next(known, twoRooms({{0.3, 0.2}, 0.1}));
  ASSERT_EQ(found.knowledge.doors.size(), 1U);
  const DoorTag& door = found.knowledge.doors[0];
  EXPECT_EQ(door.id, DoorId{1});
  EXPECT_EQ(door.state, DoorState::kClosed);
  EXPECT_EQ(door.properties.at("cost"), "3");
  const Point2 middle = Pose2{{0.3, 0.2}, 0.1} * Point2(3.25, 1);
  EXPECT_NEAR((door.pose_map.position - middle).norm(), 0, 1e-9);
  EXPECT_GT(std::cos(door.pose_map.yaw - known.doors[0].pose_map.yaw), 0.9)
      << "it still leads there";
}

TEST(Recognition, AnAutomaticDoorThatIsGoneIsForgottenAndItsIdNeverUsedAgain) {
  SemanticMap closed = twoRooms();
  closed.area_map.doors.clear();
  const Recognition gone = next(first(twoRooms()), closed);
  EXPECT_TRUE(gone.knowledge.doors.empty());
  ASSERT_EQ(gone.report.size(), 1U);
  EXPECT_EQ(gone.report[0], "door 1 'door_1' is gone: there is no door at its place");
  EXPECT_EQ(next(gone.knowledge, twoRooms()).knowledge.doors.at(0).id, DoorId{2});
}

TEST(Recognition, M21_AGivenDoorWithoutAPlaceWaitsAndComesBack) {
  Knowledge known = first(twoRooms());
  given(known.doors[0], "main door");
  SemanticMap closed = twoRooms();
  closed.area_map.doors.clear();
  const Recognition gone = next(known, closed);
  ASSERT_EQ(gone.knowledge.pending.size(), 1U);
  EXPECT_EQ(gone.knowledge.pending[0].frame_id, "map");
  EXPECT_EQ(gone.report.at(0), "door 1 'main door' waits: there is no door at its place");
  const Recognition back = next(gone.knowledge, twoRooms());
  ASSERT_EQ(back.knowledge.doors.size(), 1U);
  EXPECT_EQ(back.knowledge.doors[0].name, "main door");
  EXPECT_EQ(back.report.at(0), "door 1 'main door' is back");
  EXPECT_TRUE(back.knowledge.pending.empty());
}

TEST(Recognition, AGivenDoorThatTheMapWasAnnotatedWithIsTheOneOfItsId) {
  Knowledge known = first(twoRooms());
  given(known.doors[0], "main door");
  known.doors[0].id = DoorId{7};
  known.doors[0].width = 0;
  known.next_ids.door = 8;
  SemanticMap map = twoRooms();
  map.area_map.doors[0].id = DoorId{7};
  map.area_map.doors[0].source = TagSource::kManual;
  map.area_map.doors[0].jambs_map = {Point2(3.25, 0.5), Point2(3.25, 3.5)};
  const Recognition found = next(known, map);
  EXPECT_TRUE(difference(known, found.knowledge).empty()) << "it keeps the pose it was given";
}

TEST(Recognition, OfDoorsSideBySideEachKeepsItsId) {
  const auto map = [](double shift) {
    SemanticMap drawn = drawnAreas({"#aaaaaaa#", "#aaaaaaa#", "#########", "#bbbbbbb#"}, 0.5);
    for (const double x : {1.0, 2.0}) {
      addDoor(drawn, {Point2(x + shift, 0.75), Point2(x + shift + 0.8, 0.75)}, AreaId{1},
              AreaId{2});
    }
    return drawn;
  };
  Knowledge known = first(map(0));
  known.doors[1].state = DoorState::kClosed;
  const Recognition moved = next(known, map(0.2));
  ASSERT_EQ(moved.knowledge.doors.size(), 2U);
  EXPECT_EQ(moved.knowledge.doors[1].id, DoorId{2});
  EXPECT_EQ(moved.knowledge.doors[1].state, DoorState::kClosed);
  const Recognition between = next(known, map(0.5));
  for (const DoorTag& door : between.knowledge.doors) {
    EXPECT_GT(static_cast<int>(door.id), 2) << "half way: either may be either";
  }
}

TEST(Recognition, DoorsInWallsAcrossAreNotTheSame) {
  SemanticMap across = twoRooms();
  across.area_map.doors[0].jambs_map = {Point2(2.75, 1), Point2(3.75, 1)};
  EXPECT_EQ(next(first(twoRooms()), across).knowledge.doors.at(0).id, DoorId{2});
}

TEST(Recognition, ThatThereIsNoDoorIsKeptWhileThereIsAnAreaAtItsPlace) {
  Knowledge known = first(twoRooms());
  given(known.doors[0], "").absent = true;
  const SemanticMap one = drawnAreas({"#aaaaa#aaaaa#",  //
                                      "#aaaaaaaaaaa#",  //
                                      "#aaaaaaaaaaa#",  //
                                      "#aaaaa#aaaaa#"});
  const Recognition kept = next(known, one);
  ASSERT_EQ(kept.knowledge.doors.size(), 1U);
  EXPECT_EQ(kept.knowledge.doors[0], known.doors[0]);
  const SemanticMap part = drawnAreas({"#aaa??????????"});
  const Recognition waits = next(kept.knowledge, part);
  ASSERT_EQ(waits.knowledge.pending.size(), 1U);
  EXPECT_TRUE(waits.knowledge.doors.empty());
  EXPECT_EQ(next(waits.knowledge, one).knowledge.doors.at(0), known.doors[0]);
}

TEST(Recognition, M21_ThingsOutsideTheMapWaitAndLiveAgain) {
  Knowledge known = first(twoRooms());
  apply(PutTag{fridge({5, 1})}, known);
  const SemanticMap part = drawnAreas({"#aaaaa#",  //
                                       "#aaaaa#",  //
                                       "#aaaaa#",  //
                                       "#aaaaa#"});
  const Recognition outside = next(known, part);
  EXPECT_TRUE(outside.knowledge.objects.empty());
  ASSERT_EQ(outside.knowledge.pending.size(), 1U);
  EXPECT_EQ(outside.knowledge.pending[0].reason, "its place is not on the map");
  const Recognition back = next(outside.knowledge, twoRooms());
  ASSERT_EQ(back.knowledge.objects.size(), 1U);
  EXPECT_EQ(back.knowledge.objects[0], known.objects[0]);
}

TEST(Recognition, M18_InAnotherFrameGivenTagsWaitForTheirs) {
  Knowledge known = first(twoRooms());
  given(known.areas[1], "kitchen");
  given(known.doors[0], "kitchen door");
  apply(PutTag{fridge({5, 1})}, known);
  const Recognition away = recognise(known, "map", twoRooms(), "floor_2");
  ASSERT_EQ(away.knowledge.pending.size(), 3U);
  for (const PendingTag& p : away.knowledge.pending) EXPECT_EQ(p.frame_id, "map");
  EXPECT_EQ(away.knowledge.areas.at(0).id, AreaId{3});
  EXPECT_EQ(away.knowledge.areas.at(1).id, AreaId{4});
  EXPECT_EQ(away.knowledge.doors.at(0).id, DoorId{2});
  EXPECT_TRUE(away.knowledge.objects.empty());
  EXPECT_EQ(away.report.at(0),
            "area 2 'kitchen' waits: its place is in 'map', the map in 'floor_2'");

  const Recognition still = recognise(away.knowledge, "floor_2", twoRooms(), "floor_2");
  EXPECT_TRUE(difference(away.knowledge, still.knowledge).empty());

  const Recognition back = recognise(still.knowledge, "floor_2", twoRooms(), "map");
  EXPECT_TRUE(back.knowledge.pending.empty());
  EXPECT_EQ(findTag(back.knowledge, AreaId{2})->name, "kitchen");
  EXPECT_EQ(back.knowledge.doors.at(0).name, "kitchen door");
  EXPECT_EQ(back.knowledge.objects.at(0).name, "fridge");
  EXPECT_EQ(back.knowledge.areas.at(1).id, AreaId{5}) << "the automatic one is a new one";
}

TEST(Recognition, AFrameThatIsNotNamedIsThatOfTheTagsThatDontWait) {
  Knowledge known = first(twoRooms());
  apply(DeferTag{{fridge({1, 1}), "", "it was told before there was a map"}}, known);
  EXPECT_EQ(next(known, twoRooms()).knowledge.objects.size(), 1U);
  const Recognition away = recognise(known, "map", twoRooms(), "floor_2");
  EXPECT_EQ(away.knowledge.pending.at(0).frame_id, "map");
}

TEST(Recognition, DoorsForAMapAreTheGivenOnesInItsFrame) {
  Knowledge known = first(twoRooms());
  DoorTag tag;
  tag.id = DoorId{5};
  tag.source = TagSource::kInteraction;
  apply(PutTag{tag}, known);
  tag.id = DoorId{6};
  tag.absent = true;
  apply(DeferTag{{tag, "map", ""}}, known);
  tag.id = DoorId{7};
  apply(DeferTag{{tag, "floor_2", ""}}, known);
  const Knowledge doors = doorsFor("map", known, "map");
  ASSERT_EQ(doors.doors.size(), 2U);
  EXPECT_EQ(doors.doors[0].id, DoorId{5});
  EXPECT_EQ(doors.doors[1].id, DoorId{6});
  EXPECT_EQ(doors.next_ids.door, known.next_ids.door);
  EXPECT_TRUE(doors.areas.empty());
  EXPECT_EQ(doorsFor("floor_2", known, "map").doors.at(0).id, DoorId{7});
}

TEST(Recognition, ParametersOutOfRangeAreRefused) {
  RecognitionParams params;
  params.min_given_share = 0.4;
  EXPECT_THROW(recognise({}, "", twoRooms(), "map", params), std::invalid_argument);
}

}  // namespace
}  // namespace agrid
