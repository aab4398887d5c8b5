// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline/edit.h"

#include <limits>

#include <gtest/gtest.h>

#include "support/edited_map.h"

namespace agrid {
namespace {

using test::areaAt;
using test::doorAt;
using test::EditedMap;
using test::objectAt;

TEST(Edit, AnAreaTagNamesTheAreaThatHoldsItsPoint) {
  EditedMap map;
  ASSERT_EQ(map.known().areas.size(), 2U);
  const AreaId id = areaAt(map.map(), {2, 2})->id;
  const Edit edit = map.edit(areaAt({2, 2}, "kitchen"));
  EXPECT_TRUE(edit.changed());
  EXPECT_EQ(edit.id, static_cast<std::uint32_t>(id));
  EXPECT_EQ(findTag(map.known(), id)->name, "kitchen");
  EXPECT_EQ(findTag(map.known(), id)->source, TagSource::kManual);
  EXPECT_EQ(findTag(map.known(), id)->seed_map, Point2(2, 2));
  EXPECT_EQ(map.known().areas.size(), 2U);
}

TEST(Edit, ADoorTagNamesTheDoorThatIsMeant) {
  EditedMap map;
  ASSERT_EQ(map.known().doors.size(), 1U);
  const DoorTag before = map.known().doors.front();
  const Edit edit = map.edit(doorAt({{4.1, 2.7}, 0.3}, "front"));
  EXPECT_EQ(edit.id, static_cast<std::uint32_t>(before.id));
  EXPECT_EQ(map.known().doors.front().name, "front");
  EXPECT_EQ(map.known().doors.front().pose_map.position, before.pose_map.position);
}

TEST(Edit, ARemovedDoorIsAbsentAndComesBackUnderItsId) {
  EditedMap map;
  const DoorId id = map.known().doors.front().id;
  map.edit(RemoveTag{TagKind::kDoor, static_cast<std::uint32_t>(id)});
  EXPECT_TRUE(findTag(map.known(), id)->absent);
  map.edit(doorAt({{4.4, 2.5}, 0}));
  EXPECT_FALSE(findTag(map.known(), id)->absent);
  EXPECT_EQ(map.known().doors.size(), 1U);
}

TEST(Edit, AnObjectIsCalledByItsCategory) {
  EditedMap map;
  AddTag request = objectAt({{1, 1}, 0});
  std::get<ObjectTag>(request.tag).category = "fridge";
  EXPECT_EQ(map.edit(request).id, 1U);
  std::get<ObjectTag>(request.tag).pose_map.position.x() = 3;
  EXPECT_EQ(map.edit(request).id, 2U);
  EXPECT_EQ(map.known().objects[0].name, "fridge");
  EXPECT_EQ(map.known().objects[1].name, "fridge_2");
}

}  // namespace
}  // namespace agrid
