// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "support/retagged_map.h"

namespace agrid {
namespace {

using test::after;
using test::areaAtSeed;
using test::doorAt;
using test::structureOf;

Structure office(std::uint32_t seed, int size = 400) {
  OfficeParams params;
  params.size = size;
  params.seed = seed;
  return structureOf(OccupancyMap(generateOffice(params).grid));
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

TEST(RetagProperty, GivesTheSameAsAnnotatingFromNothing) {
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

TEST(RetagProperty, EveryAreaIsNamedOnceAndEveryPixelKeepsToTheAreasOfItsGroup) {
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
