// SPDX-License-Identifier: BSD-3-Clause
// What is put together from automatic areas is what the pixels of the joined area say.
#include <random>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "areas/area_description.h"
#include "areas/cell_labels.h"
#include "support/retagged_map.h"

namespace agrid {
namespace {

/// Measures areas by their pixels.
AreaMeasures measured(const SemanticMap& map) {
  AreaLabels labels;
  labels.tags.resize(map.area_map.areas.size());
  for (const std::uint16_t label : map.area_map.pixel_labels) {
    labels.of_pixel.push_back(label == 0 ? AreaLabels::kNone : label - std::uint32_t{1});
  }
  return describeAreas(map.map(), labels);
}

void expectAsMeasured(const SemanticMap& map) {
  const AreaMeasures slow = measured(map);
  for (std::size_t i = 0; i < slow.areas.size(); ++i) {
    const Area& area = map.area_map.areas[i];
    SCOPED_TRACE(area.name);
    EXPECT_NEAR(area.size, slow.areas[i].size, 1e-9 * area.size);
    EXPECT_EQ(area.anchor_map, slow.areas[i].anchor_map);
    EXPECT_EQ(area.anchor_clearance, slow.areas[i].anchor_clearance);
    EXPECT_EQ(area.outline_map, slow.areas[i].outline_map);
  }
  EXPECT_EQ(map.area_map.cell_areas, labelCells(map.grid(), map.map().geometry(),
                                                map.area_map.pixel_labels, map.area_map.areas));
}

TEST(JoinedAreas, AreWhatTheirPixelsSay) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    OfficeParams params;
    params.size = 400;
    params.seed = seed;
    std::mt19937 random(seed);
    const auto structure = test::structureOf(OccupancyMap(generateOffice(params).grid));
    SemanticMap map = annotate(structure, {}, {});
    std::size_t joined = 0;
    for (int step = 0; step < 15; ++step) {
      SCOPED_TRACE("office " + std::to_string(seed) + ", step " + std::to_string(step));
      const std::size_t before = map.area_map.areas.size();
      DoorTag door = map.knowledge.doors.at(random() % map.knowledge.doors.size());
      door.absent = random() % 4 != 0;  // some come back
      door.source = TagSource::kManual;
      map = test::after(map, {PutTag{door}});
      joined += map.area_map.areas.size() < before ? 1 : 0;
      expectAsMeasured(map);
      if (HasFailure()) return;
    }
    EXPECT_GT(joined, 3U);
  }
}

TEST(JoinedAreas, NoPixelIsWritten) {
  OfficeParams params;
  params.size = 400;
  const auto structure = test::structureOf(OccupancyMap(generateOffice(params).grid));
  const SemanticMap map = annotate(structure, {}, {});
  DoorTag door = map.knowledge.doors.at(2);
  door.absent = true;
  door.source = TagSource::kManual;
  const SemanticMap joined = test::after(map, {PutTag{door}});
  ASSERT_LT(joined.area_map.areas.size(), map.area_map.areas.size());
  const auto& slots = map.area_map.pixel_labels.slots();
  std::size_t written = 0;
  slots.forEachDifference(joined.area_map.pixel_labels.slots(), [&](std::size_t) { ++written; });
  EXPECT_EQ(written, 0U);
  EXPECT_EQ(slots.pages()[0], joined.area_map.pixel_labels.slots().pages()[0]);
}

}  // namespace
}  // namespace agrid
