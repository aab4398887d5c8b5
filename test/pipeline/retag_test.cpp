// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "agrid/pipeline.h"
#include "support/ascii_map.h"

namespace agrid {
namespace {

Structure structureOf(const OccupancyMap& map) {
  return extractStructure(std::make_shared<const OccupancyMap>(map), {});
}

Structure office(std::uint32_t seed, int size = 400) {
  OfficeParams params;
  params.size = size;
  params.seed = seed;
  return structureOf(OccupancyMap(generateOffice(params).grid));
}

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

DoorTag doorAt(std::uint32_t id, const Point2& at, double yaw = 0) {
  DoorTag tag;
  tag.id = DoorId{id};
  tag.name = "given_" + std::to_string(id);
  tag.pose_map = {at, yaw};
  tag.source = TagSource::kManual;
  return tag;
}

AreaTag areaAtSeed(std::uint32_t id, const std::string& name, const Point2& seed) {
  AreaTag tag;
  tag.id = AreaId{id};
  tag.name = name;
  tag.seed_map = seed;
  tag.source = TagSource::kManual;
  return tag;
}

SemanticMap after(const SemanticMap& map, const std::vector<Change>& changes) {
  Knowledge known = map.knowledge;
  for (const Change& change : changes) apply(change, known);
  return retag(map, known);
}

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

void expectSame(const SemanticMap& a, const SemanticMap& b) {
  ASSERT_EQ(a.area_map.areas.size(), b.area_map.areas.size());
  for (std::size_t i = 0; i < a.area_map.areas.size(); ++i) {
    const Area& x = a.area_map.areas[i];
    const Area& y = b.area_map.areas[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.anchor_map, y.anchor_map);
    EXPECT_EQ(x.anchor_clearance, y.anchor_clearance);
    EXPECT_EQ(x.outline_map, y.outline_map);
    EXPECT_EQ(x.size, y.size);
    EXPECT_EQ(x.category_guess, y.category_guess);
  }
  ASSERT_EQ(a.area_map.doors.size(), b.area_map.doors.size());
  for (std::size_t i = 0; i < a.area_map.doors.size(); ++i) {
    const Door& x = a.area_map.doors[i];
    const Door& y = b.area_map.doors[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.areas, y.areas);
    EXPECT_EQ(x.jambs_map.a, y.jambs_map.a);
    EXPECT_EQ(x.jambs_map.b, y.jambs_map.b);
    EXPECT_EQ(x.cells, y.cells);
  }
  EXPECT_EQ(a.area_map.pixel_labels, b.area_map.pixel_labels);
  EXPECT_EQ(a.area_map.cell_areas, b.area_map.cell_areas);
  EXPECT_TRUE(difference(a.knowledge, b.knowledge).empty());
}

/// Random changes of a kind that people make.
std::vector<Change> randomChanges(const SemanticMap& map, std::mt19937& random) {
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const MapGeometry& geometry = map.map().geometry();
  const Pixel pixel{static_cast<int>(pick(static_cast<std::size_t>(geometry.width))),
                    static_cast<int>(pick(static_cast<std::size_t>(geometry.height)))};
  const Point2 at = geometry.center(pixel);
  const Knowledge& known = map.knowledge;
  std::vector<Change> changes;
  switch (pick(5)) {
    case 0: {
      DoorTag door = doorAt(known.next_ids.door, at, static_cast<double>(pick(4)) * 0.7);
      if (pick(2) == 0) door.width = 1.2;
      changes.emplace_back(PutTag{door});
      break;
    }
    case 1: {
      DoorTag door = known.doors.at(pick(known.doors.size()));
      door.absent = !door.absent;
      door.source = TagSource::kManual;
      changes.emplace_back(PutTag{door});
      break;
    }
    case 2:
      changes.emplace_back(
          PutTag{areaAtSeed(known.next_ids.area, "a" + std::to_string(pick(99)), at)});
      break;
    case 3:
      changes.emplace_back(DropTag{
          TagKind::kDoor, static_cast<std::uint32_t>(known.doors.at(pick(known.doors.size())).id)});
      break;
    default:
      changes.emplace_back(DropTag{
          TagKind::kArea, static_cast<std::uint32_t>(known.areas.at(pick(known.areas.size())).id)});
  }
  return changes;
}

TEST(Retag, GivesTheSameAsAnnotatingFromNothing) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    SemanticMap map = annotate(office(seed), {}, {});
    for (int step = 0; step < 25; ++step) {
      Knowledge known = map.knowledge;
      for (const Change& change : randomChanges(map, random)) apply(change, known);
      map = retag(map, known);
      SCOPED_TRACE("office " + std::to_string(seed) + ", step " + std::to_string(step));
      expectSame(map, annotate(map.structure, known, {}));
      // what is known afterwards says it all: a restart finds the same
      expectSame(map, annotate(map.structure, map.knowledge, {}));
      if (HasFailure()) return;
    }
  }
}

TEST(Retag, EveryAreaIsNamedOnceAndEveryPixelKeepsToTheAreasOfItsGroup) {
  std::mt19937 random(5);
  SemanticMap map = annotate(office(5), {}, {});
  const auto& before = map.area_map.pixel_labels.vector();
  const std::vector<std::uint16_t> automatic(before.begin(), before.end());
  for (int step = 0; step < 40; ++step) {
    map = after(map, randomChanges(map, random));
    std::set<std::string> names;
    for (const AreaTag& tag : map.knowledge.areas) EXPECT_TRUE(names.insert(tag.name).second);
    for (std::size_t i = 0; i < automatic.size(); ++i) {
      if (automatic[i] != 0) {
        ASSERT_NE(map.area_map.pixel_labels[i], 0);
      }
    }
    for (const Area& area : map.area_map.areas) {
      ASSERT_EQ(areaAt(map, area.anchor_map), &area) << area.name;
    }
  }
}

}  // namespace
}  // namespace agrid
