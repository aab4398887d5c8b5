// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline/edit.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/edited_map.h"

namespace agrid {
namespace {

using test::areaAt;
using test::doorAt;
using test::EditedMap;
using test::expectKnown;
using test::expectRefused;
using test::objectAt;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename T>
T& tagIn(AddTag& request) {
  return std::get<T>(request.tag);
}

std::uint32_t idAt(EditedMap& map, const Point2& point) {
  return static_cast<std::uint32_t>(areaAt(map.map(), point)->id);
}

AddTag withId(AddTag request, std::uint32_t id) {
  std::visit([id](auto& tag) { tag.id = static_cast<decltype(tag.id)>(id); }, request.tag);
  return request;
}

AddTag replacing(AddTag request) {
  request.replace = true;
  return request;
}

AddTag unmoved(AddTag request, std::uint32_t id) {
  request.placement = Placement::kUnchanged;
  return withId(std::move(request), id);
}

TEST(Edit, T1_APoseThatIsNoNumberIsRefused) {
  EditedMap map;
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e308}) {
    expectRefused(EditErrorCode::kInvalid, "finite", areaAt({bad, 1}, "a"), map);
    expectRefused(EditErrorCode::kInvalid, "finite", areaAt({1, bad}, "a"), map);
    for (const Pose2& pose : {Pose2{{bad, 1}, 0}, Pose2{{1, bad}, 0}, Pose2{{1, 1}, bad}}) {
      expectRefused(EditErrorCode::kInvalid, "finite", doorAt(pose), map);
      expectRefused(EditErrorCode::kInvalid, "finite", objectAt(pose), map);
    }
    AddTag box = objectAt({{1, 1}, 0});
    tagIn<ObjectTag>(box).size = {1, bad};
    expectRefused(EditErrorCode::kInvalid, "width must lie in [0, ", box, map);
    tagIn<ObjectTag>(box).size = {bad, 1};
    expectRefused(EditErrorCode::kInvalid, "length must lie in [0, ", box, map);
    tagIn<ObjectTag>(box).size = {1, 1};
    tagIn<ObjectTag>(box).height = bad;
    expectRefused(EditErrorCode::kInvalid, "height must lie in [0, ", box, map);
  }
}

TEST(Edit, T1_AnyHeadingNeedsNone) {
  EditedMap map;
  AddTag request = objectAt({{1, 1}, kNan}, "plant");
  request.placement = Placement::kAnyHeading;
  map.edit(request);
  EXPECT_EQ(map.known().objects.at(0).pose_map.yaw, 0);
  request = doorAt({{4.5, 2.5}, kNan});
  request.placement = Placement::kAnyHeading;
  EXPECT_EQ(map.edit(request).id, static_cast<std::uint32_t>(map.known().doors.at(0).id));
}

TEST(Edit, T2_OutsideTheMapIsRefusedWithItsCorners) {
  EditedMap map;
  for (const Point2& point : {Point2(-0.1, 1), Point2(1, 5.1), Point2(40, 2), Point2(2, -1e8)}) {
    expectRefused(EditErrorCode::kOutside, "(9.75, 5.00)", areaAt(point), map);
    expectRefused(EditErrorCode::kOutside, "(9.75, 5.00)", doorAt({point, 0}), map);
    expectRefused(EditErrorCode::kOutside, "(9.75, 5.00)", objectAt({point, 0}), map);
  }
}

TEST(Edit, T3_InUnknownSpaceAnAreaWaitsAndAnObjectIsTaken) {
  EditedMap map;
  const Edit area = map.edit(areaAt({9.5, 2}, "lab"));
  EXPECT_NE(area.message.find("unknown space"), std::string::npos);
  ASSERT_EQ(map.known().pending.size(), 1U);
  EXPECT_EQ(nameOf(map.known().pending[0].tag), "lab");
  EXPECT_NE(map.known().pending[0].reason.find("unknown space"), std::string::npos);
  expectKnown(area.id, areaAt({9.5, 2}, "lab"), map);
  const Edit object = map.edit(objectAt({{9.5, 2}, 0}, "crate"));
  EXPECT_NE(object.message.find("unknown space"), std::string::npos);
  EXPECT_EQ(map.known().objects.size(), 1U);
  EditParams strict;
  strict.allow_unknown = false;
  expectRefused(EditErrorCode::kOutside, "unknown", areaAt({9.4, 3}, "b"), map, strict);
  expectRefused(EditErrorCode::kOutside, "unknown", objectAt({{9.4, 3}, 0}, "b"), map, strict);
}

TEST(Edit, T3_ATagThatWaitsIsChangedMovedAndForgotten) {
  EditedMap map;
  const std::uint32_t id = map.edit(areaAt({9.5, 2}, "lab")).id;
  expectRefused(EditErrorCode::kNameTaken, "lab", areaAt({2, 2}, "Lab"), map);
  map.edit(unmoved(areaAt({0, 0}, "library"), id));
  ASSERT_EQ(map.known().pending.size(), 1U);
  EXPECT_EQ(nameOf(map.known().pending[0].tag), "library");
  const std::uint32_t there = idAt(map, {2, 2});
  EXPECT_EQ(map.edit(replacing(areaAt({2, 2}, "library"))).id, id);
  EXPECT_TRUE(map.known().pending.empty());
  EXPECT_EQ(findTag(map.known(), AreaId{there}), nullptr);
  map.edit(withId(areaAt({9.5, 2}), id));
  ASSERT_EQ(map.known().pending.size(), 1U);
  map.edit(RemoveTag{TagKind::kArea, id});
  EXPECT_TRUE(map.known().pending.empty());
  expectRefused(EditErrorCode::kUnknownName, "no area", RemoveTag{TagKind::kArea, id}, map);
}

TEST(Edit, T4_AnAreaInAnObstacleIsRefusedWithTheNearestFreePoint) {
  EditedMap map;
  // the wall at the left is 0.25 m thick
  expectRefused(EditErrorCode::kOutside, "nearest free point is (0.28, 2.02)", areaAt({0.1, 2.01}),
                map);
  map.edit(objectAt({{0.1, 2}, 0}, "pipe"));
  EXPECT_EQ(map.known().objects.size(), 1U);
}

TEST(Edit, T5_TheSameAgainChangesNothing) {
  EditedMap map;
  AddTag box = objectAt({{1, 1}, 0.5});
  tagIn<ObjectTag>(box).category = "fridge";
  tagIn<ObjectTag>(box).size = {0.6, 0.7};
  tagIn<ObjectTag>(box).properties = {{"door", "left"}, {"empty", ""}};
  AddTag area = areaAt({2, 2}, "kitchen");
  tagIn<AreaTag>(area).category = "room";
  tagIn<AreaTag>(area).properties = {{"alias", "galley, cuisine"}, {"none", ""}};
  const std::vector<EditRequest> requests{
      area, areaAt({6, 2}),       doorAt({{4.4, 2.5}, 0}, "front"), objectAt({{1, 1}, 0}, "plant"),
      box,  objectAt({{2, 1}, 0})};
  for (const EditRequest& request : requests) {
    const Edit edit = map.edit(request);
    EXPECT_TRUE(edit.changed());
    expectKnown(edit.id, request, map);
  }
  for (const EditRequest& request : requests) EXPECT_FALSE(map.edit(request).changed());
  EXPECT_EQ(map.known().objects.size(), 3U);
  const SetDoor closed{map.known().doors[0].id, DoorState::kClosed};
  EXPECT_TRUE(map.edit(closed).changed());
  EXPECT_FALSE(map.edit(closed).changed());
  // from elsewhere in the same area, and by an alias
  EXPECT_FALSE(map.edit(areaAt({3, 3}, "kitchen")).changed());
  EXPECT_FALSE(map.edit(areaAt({3, 3}, "Cuisine")).changed());
}

TEST(Edit, T6_ANameIsTakenUnlessItsBearerMoves) {
  EditedMap map;
  AddTag fridge = objectAt({{1, 1}, 0}, "fridge");
  tagIn<ObjectTag>(fridge).properties = {{"alias", "ice box"}};
  const std::uint32_t id = map.edit(fridge).id;
  for (const char* name : {"fridge", "FRIDGE", "Ice Box"}) {
    expectRefused(EditErrorCode::kNameTaken, "object 1 'fridge'", objectAt({{2, 1}, 0}, name), map);
  }
  AddTag aliased = objectAt({{2, 1}, 0}, "cooler");
  tagIn<ObjectTag>(aliased).properties = {{"alias", "x,Fridge"}};
  expectRefused(EditErrorCode::kNameTaken, "'Fridge'", aliased, map);
  EXPECT_EQ(map.edit(replacing(objectAt({{2, 1}, 0}, "fridge"))).id, id);
  ASSERT_EQ(map.known().objects.size(), 1U);
  EXPECT_EQ(map.known().objects[0].pose_map.position, Point2(2, 1));
  EXPECT_EQ(map.known().objects[0].properties.at("alias"), "ice box");
  // another kind may have the name
  EXPECT_TRUE(map.edit(areaAt({2, 2}, "fridge")).changed());
  // so is that of an area that was found automatically
  const std::string found = findTag(map.known(), AreaId{idAt(map, {6, 2})})->name;
  expectRefused(EditErrorCode::kNameTaken, found, unmoved(areaAt({0, 0}, found), idAt(map, {2, 2})),
                map);
}

TEST(Edit, T6_AMovedAreaTakesThePlaceOfAnother) {
  EditedMap map;
  const std::uint32_t left = map.edit(areaAt({2, 2}, "kitchen")).id;
  const std::uint32_t right = idAt(map, {6, 2});
  expectRefused(EditErrorCode::kNameTaken, "replace", areaAt({6, 2}, "kitchen"), map);
  EXPECT_EQ(map.edit(replacing(areaAt({6, 2}, "kitchen"))).id, left);
  EXPECT_EQ(findTag(map.known(), AreaId{left})->seed_map, Point2(6, 2));
  EXPECT_EQ(findTag(map.known(), AreaId{right}), nullptr);  // it was automatic
}

TEST(Edit, T7_TwoNamesForOneAreaAreRefusedButObjectsMayStandInOnePlace) {
  EditedMap map;
  const std::uint32_t id = map.edit(areaAt({2, 2}, "kitchen")).id;
  const std::uint32_t hall = map.edit(areaAt({6, 2}, "hall")).id;
  expectRefused(EditErrorCode::kNameTaken, "'kitchen'", areaAt({3, 3}, "office"), map);
  expectRefused(EditErrorCode::kNameTaken, "'kitchen'", withId(areaAt({3, 3}), hall), map);
  EXPECT_EQ(map.edit(withId(areaAt({3, 3}, "galley"), id)).id, id);
  EXPECT_EQ(map.edit(replacing(areaAt({3, 3}, "office"))).id, id);
  EXPECT_EQ(findTag(map.known(), AreaId{id})->name, "office");
  AddTag moved = withId(areaAt({3, 3}), hall);
  moved.replace = true;
  EXPECT_EQ(map.edit(moved).id, hall);
  ASSERT_EQ(map.known().pending.size(), 1U);  // what was said of the office is not lost
  EXPECT_EQ(nameOf(map.known().pending[0].tag), "office");
  map.edit(objectAt({{1, 1}, 0}, "table"));
  map.edit(objectAt({{1, 1}, 0}, "lamp"));
  EXPECT_EQ(map.known().objects.size(), 2U);
}

TEST(Edit, T8_NamesThatCannotBeAreRefused) {
  EditedMap map;
  const std::string nul("a\0b", 3);
  for (const std::string& name :
       {std::string(" "), std::string("  "), std::string(257, 'a'), std::string("\xff"),
        std::string("a\nb"), nul, std::string("a\xE2\x80\xAE") + "b", std::string("\x7f")}) {
    expectRefused(EditErrorCode::kInvalid, "name", areaAt({2, 2}, name), map);
    expectRefused(EditErrorCode::kInvalid, "name", doorAt({{4.4, 2.5}, 0}, name), map);
    AddTag object = objectAt({{1, 1}, 0}, name);
    expectRefused(EditErrorCode::kInvalid, "name", object, map);
    tagIn<ObjectTag>(object).name.clear();
    tagIn<ObjectTag>(object).category = name;
    expectRefused(EditErrorCode::kInvalid, "category", object, map);
    tagIn<ObjectTag>(object).category.clear();
    tagIn<ObjectTag>(object).properties = {{name, "value"}};
    expectRefused(EditErrorCode::kInvalid, "key", object, map);
  }
  AddTag object = objectAt({{1, 1}, 0});
  for (const std::string& value : {std::string(5000, 'v'), nul, std::string("\xc3")}) {
    tagIn<ObjectTag>(object).properties = {{"key", value}};
    expectRefused(EditErrorCode::kInvalid, "property 'key'", object, map);
  }
  tagIn<ObjectTag>(object).properties = {{"alias", "fine, \xE2\x80\xAE"}};
  expectRefused(EditErrorCode::kInvalid, "alias", object, map);
  tagIn<ObjectTag>(object).properties.clear();
  for (int i = 0; i <= 64; ++i) tagIn<ObjectTag>(object).properties[std::to_string(i)] = "v";
  expectRefused(EditErrorCode::kInvalid, "65 properties", object, map);
}

TEST(Edit, T9_NamesAreKeptByteForByte) {
  EditedMap map;
  double x = 0.5;
  for (const char* name : {"a: b", "- x", "*a", "!!x", "#", "\"'", "{{", "---", "caffè", "厨房",
                           "🍳", " spaced ", "../../etc/x", ";id;"}) {
    const Edit edit = map.edit(objectAt({{x += 0.1, 1}, 0}, name));
    EXPECT_EQ(findTag(map.known(), ObjectId{edit.id})->name, name);
    expectKnown(edit.id, objectAt({{x, 1}, 0}, name), map);
  }
}

TEST(Edit, T13_WhatIsNotThereCannotBeRemovedOrChanged) {
  EditedMap map;
  const std::uint32_t object = map.edit(objectAt({{1, 1}, 0})).id;
  const std::uint32_t area = map.edit(areaAt({2, 2}, "kitchen")).id;
  const auto door = static_cast<std::uint32_t>(map.known().doors[0].id);
  for (const RemoveTag& request :
       {RemoveTag{TagKind::kObject, object}, RemoveTag{TagKind::kArea, area},
        RemoveTag{TagKind::kDoor, door}}) {
    EXPECT_TRUE(map.edit(request).changed());
    expectRefused(EditErrorCode::kUnknownName, "", request, map);
    expectRefused(EditErrorCode::kUnknownName, "99", RemoveTag{request.kind, 99}, map);
  }
  expectRefused(EditErrorCode::kUnknownName, "99", withId(areaAt({2, 2}), 99), map);
  expectRefused(EditErrorCode::kUnknownName, "99", withId(doorAt({{4.4, 2.5}, 0}), 99), map);
  expectRefused(EditErrorCode::kUnknownName, "99", unmoved(objectAt({}), 99), map);
  expectRefused(EditErrorCode::kUnknownName, "99", SetDoor{DoorId{99}, DoorState::kOpen}, map);
  expectRefused(EditErrorCode::kUnknownName, "", SetDoor{DoorId{door}, DoorState::kOpen}, map);
}

TEST(Edit, T16_NoMoreTagsThanAllowed) {
  EditedMap map;
  EditParams params;
  params.max_tags = map.known().areas.size() + map.known().doors.size() + 1;
  map.edit(objectAt({{1, 1}, 0}, "plant"), params);
  expectRefused(EditErrorCode::kLimit, "4 tags", objectAt({{2, 1}, 0}, "table"), map, params);
  EXPECT_TRUE(map.edit(replacing(objectAt({{2, 1}, 0}, "plant")), params).changed());
  EXPECT_TRUE(map.edit(areaAt({2, 2}, "kitchen"), params).changed());
  map.edit(RemoveTag{TagKind::kObject, 1}, params);
  EXPECT_EQ(map.edit(objectAt({{2, 1}, 0}, "table"), params).id, 2U);
}

}  // namespace
}  // namespace agrid
