// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/retagged_map.h"

namespace agrid {
namespace {

using test::after;
using test::areaAtSeed;
using test::doorAt;
using test::structureOf;

/// A room of 8 m x 4 m with a wall that leaves a gap of 1 m in the middle, at 0.1 m.
std::vector<std::string> hallAndRoom() {
  std::vector<std::string> rows;
  for (int y = 0; y < 40; ++y) {
    std::string row(82, '.');
    row.front() = row.back() = '#';
    if (y < 15 || y >= 25) row[60] = '#';
    if (y == 0 || y == 39) row.assign(82, '#');
    rows.push_back(row);
  }
  return rows;
}

SemanticMap twoRooms() { return annotate(structureOf(test::asciiMap(hallAndRoom(), 0.1)), {}, {}); }

TEST(Retag, EachAreaAndDoorHasATag) {
  const SemanticMap map = twoRooms();
  ASSERT_EQ(map.area_map.areas.size(), 2U);
  ASSERT_EQ(map.area_map.doors.size(), 1U);
  ASSERT_EQ(map.knowledge.areas.size(), 2U);
  ASSERT_EQ(map.knowledge.doors.size(), 1U);
  EXPECT_EQ(map.knowledge.next_ids.area, 3U);
  EXPECT_EQ(map.knowledge.next_ids.door, 2U);
  EXPECT_EQ(map.knowledge.areas[0].name, "area_1");
  EXPECT_EQ(map.knowledge.areas[0].outline_map, map.area_map.areas[0].outline_map);
}

TEST(Retag, ADoorTagPartsItsAreaAndTakingItBackJoinsItAgain) {
  const SemanticMap map = twoRooms();
  const AreaId hall = areaAt(map, {2, 2})->id;
  const SemanticMap parted = after(map, {PutTag{doorAt(7, {3, 2})}});
  ASSERT_EQ(parted.area_map.areas.size(), 3U);
  ASSERT_EQ(parted.area_map.doors.size(), 2U);
  const Door& door = parted.area_map.doors.back();
  EXPECT_EQ(door.id, DoorId{7});
  EXPECT_EQ(door.kind, DoorKind::kDoor);
  EXPECT_NEAR(door.width, 3.8, 0.11);
  EXPECT_EQ(door.areas[0], areaAt(parted, {2, 2})->id);
  EXPECT_EQ(door.areas[1], areaAt(parted, {4, 2})->id);
  EXPECT_NE(door.areas[0], door.areas[1]);
  // the part that holds the anchor keeps the id, the other one has a new one
  EXPECT_EQ(std::max(areaAt(parted, {2, 2})->id, areaAt(parted, {4, 2})->id), AreaId{3});
  const SemanticMap joined = after(parted, {DropTag{TagKind::kDoor, 7}});
  ASSERT_EQ(joined.area_map.areas.size(), 2U);
  EXPECT_EQ(areaAt(joined, {2, 2})->id, hall);
  EXPECT_EQ(joined.area_map.pixel_labels, map.area_map.pixel_labels);
  EXPECT_EQ(joined.area_map.areas[0].outline_map, map.area_map.areas[0].outline_map);
  EXPECT_EQ(joined.knowledge.next_ids.area, 4U) << "ids are not used twice";
}

TEST(Retag, AnAbsentDoorJoinsTheAreasOnBothSides) {
  const SemanticMap map = twoRooms();
  DoorTag none = map.knowledge.doors.front();
  none.absent = true;
  none.source = TagSource::kManual;
  const SemanticMap joined = after(map, {PutTag{none}});
  ASSERT_EQ(joined.area_map.areas.size(), 1U);
  EXPECT_EQ(joined.area_map.areas[0].id, AreaId{1});
  EXPECT_TRUE(joined.area_map.doors.empty());
  EXPECT_EQ(joined.knowledge.doors.size(), 1U) << "that there is no door is known";
  EXPECT_NEAR(joined.area_map.areas[0].size,
              map.area_map.areas[0].size + map.area_map.areas[1].size, 1e-9);
  const SemanticMap parted = after(joined, {DropTag{TagKind::kDoor, 1}});
  EXPECT_EQ(parted.area_map.areas.size(), 2U);
  EXPECT_EQ(parted.area_map.doors.size(), 1U);
}

TEST(Retag, AGivenDoorOnABorderNamesIt) {
  const SemanticMap map = twoRooms();
  DoorTag named = map.knowledge.doors.front();
  named.name = "kitchen door";
  named.state = DoorState::kClosed;
  named.source = TagSource::kInteraction;
  const SemanticMap result = after(map, {PutTag{named}});
  ASSERT_EQ(result.area_map.doors.size(), 1U);
  EXPECT_EQ(result.area_map.doors[0].name, "kitchen door");
  EXPECT_EQ(result.area_map.doors[0].state, DoorState::kClosed);
  EXPECT_EQ(result.area_map.doors[0].confidence, 1);
  EXPECT_TRUE(result.area_map.pixel_labels.shares(map.area_map.pixel_labels))
      << "a name costs no pixel";
}

TEST(Retag, AnAreaTagOwnsTheAreaThatHoldsIt) {
  const SemanticMap map = twoRooms();
  const SemanticMap named = after(map, {PutTag{areaAtSeed(9, "kitchen", {7, 2})}});
  ASSERT_EQ(named.area_map.areas.size(), 2U);
  EXPECT_EQ(areaAt(named, {7, 2})->id, AreaId{9});
  EXPECT_EQ(areaAt(named, {7, 2})->name, "kitchen");
  EXPECT_EQ(named.knowledge.areas.size(), 2U) << "the automatic tag is forgotten";
}

TEST(Retag, OfTwoGivenTagsInOneAreaTheSecondWaits) {
  const SemanticMap map = twoRooms();
  const SemanticMap result = after(map, {PutTag{areaAtSeed(9, "kitchen", {7, 2})},
                                         PutTag{areaAtSeed(10, "galley", {7.5, 2.5})}});
  EXPECT_EQ(areaAt(result, {7.5, 2.5})->name, "kitchen");
  ASSERT_EQ(result.knowledge.pending.size(), 1U);
  EXPECT_EQ(nameOf(result.knowledge.pending[0].tag), "galley");
  EXPECT_FALSE(result.knowledge.pending[0].reason.empty());
}

TEST(Retag, AGivenTagInFreeSpaceOfNoAreaMakesOne) {
  auto rows = hallAndRoom();
  for (std::size_t y = 5; y < 19; ++y) rows[y].replace(10, 14, 14, '#');
  rows[12].replace(17, 2, "..");
  rows[13].replace(17, 2, "..");  // 0.04 m^2 within a pillar
  const SemanticMap map = annotate(structureOf(test::asciiMap(rows, 0.1)), {}, {});
  const Point2 inside(1.75, 2.65);
  ASSERT_EQ(areaAt(map, inside), nullptr);
  const SemanticMap result = after(map, {PutTag{areaAtSeed(5, "shaft", inside)}});
  ASSERT_NE(areaAt(result, inside), nullptr);
  EXPECT_EQ(areaAt(result, inside)->id, AreaId{5});
  EXPECT_NEAR(areaAt(result, inside)->size, 0.04, 1e-9);
  const SemanticMap back = after(result, {DropTag{TagKind::kArea, 5}});
  EXPECT_EQ(areaAt(back, inside), nullptr);
  EXPECT_EQ(back.area_map.pixel_labels, map.area_map.pixel_labels);
}

TEST(Retag, ADoorInAWallLeadsFromOneSideToTheOther) {
  const SemanticMap map = twoRooms();
  const SemanticMap result = after(map, {PutTag{doorAt(4, {6.05, 1.0})}});
  ASSERT_EQ(result.area_map.doors.size(), 2U);
  const Door& door = result.area_map.doors.back();
  EXPECT_EQ(door.id, DoorId{4});
  EXPECT_EQ(door.areas[0], areaAt(map, {5, 1})->id);
  EXPECT_EQ(door.areas[1], areaAt(map, {7, 1})->id);
  EXPECT_EQ(result.area_map.areas.size(), 2U);
}

TEST(Retag, ADoorThatPartsNothingHasOneAreaOnBothSides) {
  const SemanticMap map = twoRooms();
  DoorTag narrow = doorAt(4, {3, 2});
  narrow.width = 1;
  const SemanticMap result = after(map, {PutTag{narrow}});
  EXPECT_EQ(result.area_map.areas.size(), 2U);
  ASSERT_EQ(result.area_map.doors.size(), 2U);
  EXPECT_EQ(result.area_map.doors.back().areas[0], result.area_map.doors.back().areas[1]);
}

TEST(Retag, OfTwoGivenDoorsOnOneBorderNoneIsLost) {
  const SemanticMap map = twoRooms();
  DoorTag named = map.knowledge.doors.front();
  named.name = "kitchen door";
  named.source = TagSource::kManual;
  DoorTag other = named;
  other.id = DoorId{8};
  other.name = "hatch";
  other.pose_map.position.y() += 0.3;
  const SemanticMap result = after(map, {PutTag{named}, PutTag{other}});
  EXPECT_NE(findTag(result.knowledge, named.id), nullptr);
  EXPECT_TRUE(findTag(result.knowledge, other.id) != nullptr ||
              result.knowledge.pending.size() == 1);
}

TEST(Retag, AGivenDoorBeatsAnAutomaticTagThatLiesNearer) {
  const SemanticMap map = twoRooms();
  DoorTag given = map.knowledge.doors.front();
  given.id = DoorId{9};
  given.name = "kitchen door";
  given.source = TagSource::kManual;
  given.pose_map.position.y() += 0.1;
  const SemanticMap result = after(map, {PutTag{given}});
  ASSERT_EQ(result.area_map.doors.size(), 1U);
  EXPECT_EQ(result.area_map.doors[0].name, "kitchen door");
  EXPECT_TRUE(result.knowledge.pending.empty());
}

TEST(Retag, AStretchOfABorderIsNamedOnItsOwn) {
  // an open border of 3.8 m between two parts of a hall, one of which a door parts again
  std::vector<std::string> rows = hallAndRoom();
  const SemanticMap map = annotate(structureOf(test::asciiMap(rows, 0.1)), {}, {});
  DoorTag across = doorAt(5, {7, 2}, std::acos(-1.0) / 2);
  const SemanticMap parted = after(map, {PutTag{across}});
  // the given door meets the gap in its middle: the gap has two stretches
  std::vector<DoorTag> stretches;
  for (const DoorTag& tag : parted.knowledge.doors) {
    if (tag.id != DoorId{5}) stretches.push_back(tag);
  }
  ASSERT_EQ(stretches.size(), 2U);
  stretches[1].name = "hatch";
  stretches[1].source = TagSource::kManual;
  const SemanticMap named = after(parted, {PutTag{stretches[1]}});
  EXPECT_EQ(named.area_map.doors.size(), 3U);
  EXPECT_EQ(named.area_map.areas.size(), parted.area_map.areas.size());
  EXPECT_EQ(named.area_map.pixel_labels, parted.area_map.pixel_labels);
  EXPECT_TRUE(named.knowledge.pending.empty());
}

}  // namespace
}  // namespace agrid
