// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "agrid/areas/area_segmentation.h"
#include "agrid/evaluation/office_generator.h"
#include "support/ascii_map.h"
#include "support/generated_maps.h"

namespace agrid {
namespace {

SemanticMap annotated(const OccupancyGrid& grid, const std::vector<Tag>& given = {}) {
  const PipelineParams params;
  Knowledge known;
  for (const Tag& tag : given) apply(PutTag{tag}, known);
  return annotate(extractStructure(std::make_shared<const OccupancyMap>(grid), params), known,
                  params);
}

OccupancyGrid office(std::uint32_t seed) {
  OfficeParams params;
  params.size = 500;
  params.seed = seed;
  return generateOffice(params).grid;
}

double distanceToNearest(const Point2& point, const std::vector<Point2>& others) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point2& other : others) nearest = std::min(nearest, (point - other).norm());
  return nearest;
}

TEST(Pipeline, EveryCellAndPixelRefersToAnAreaThatExists) {
  const SemanticMap map = annotated(office(1));
  ASSERT_GT(map.area_map.areas.size(), 3U);
  ASSERT_EQ(map.area_map.cell_areas.size(), map.grid().cellCount());
  ASSERT_EQ(map.area_map.pixel_labels.size(), map.map().pixels().size());
  for (const AreaId id : map.area_map.cell_areas) {
    EXPECT_TRUE(id == AreaId{0} || findArea(map, id) != nullptr);
  }
  for (std::size_t i = 0; i < map.area_map.pixel_labels.size(); ++i) {
    const std::uint16_t label = map.area_map.pixel_labels[i];
    ASSERT_LE(label, map.area_map.areas.size());
    ASSERT_TRUE(label == 0 || map.map().pixels()[i] == Occupancy::kFree);
  }
  EXPECT_EQ(map.graph.passages.size(), map.area_map.areas.size());
}

TEST(Pipeline, FindsTheAreasThatProposingAndGrowingFindOneAfterTheOther) {
  const Structure structure =
      extractStructure(std::make_shared<const OccupancyMap>(office(4)), PipelineParams());
  AreaTag area;
  area.seed_map = annotate(structure, {}, PipelineParams()).area_map.areas.front().anchor_map;
  DoorTag door;
  door.pose_map = {annotate(structure, {}, PipelineParams()).area_map.areas.back().anchor_map, 0.4};
  for (const AreaMethod method :
       {AreaMethod::kBorders, AreaMethod::kPersistence, AreaMethod::kPaper}) {
    PipelineParams params;
    params.areas.method = method;
    std::vector<Tag> tags{area, door};
    const TaggedAreas found = findAreas(*structure.map, *structure.grid, tags, params.areas);
    for (Tag& tag : proposeTags(*structure.map, tags, params.areas)) tags.push_back(std::move(tag));
    const AreaMap expected = segmentAreas(*structure.map, *structure.grid, tags, params.areas);
    EXPECT_EQ(found.tags.size(), tags.size());
    EXPECT_EQ(found.area_map.pixel_labels, expected.pixel_labels);
    EXPECT_EQ(found.area_map.warnings, expected.warnings);
    ASSERT_EQ(found.area_map.areas.size(), expected.areas.size());
    for (std::size_t i = 0; i < expected.areas.size(); ++i) {
      EXPECT_EQ(found.area_map.areas[i].id, expected.areas[i].id);
    }
    ASSERT_EQ(found.area_map.doors.size(), expected.doors.size());
    for (std::size_t i = 0; i < expected.doors.size(); ++i) {
      EXPECT_EQ(found.area_map.doors[i].jambs_map.a, expected.doors[i].jambs_map.a);
    }
  }
}

TEST(Pipeline, TheSameInputGivesTheSameResult) {
  const SemanticMap a = annotated(office(2));
  const SemanticMap b = annotated(office(2));
  EXPECT_EQ(a.grid().x(), b.grid().x());
  EXPECT_EQ(a.grid().y(), b.grid().y());
  EXPECT_EQ(a.area_map.pixel_labels, b.area_map.pixel_labels);
  EXPECT_EQ(a.area_map.cell_areas, b.area_map.cell_areas);
  ASSERT_EQ(a.area_map.doors.size(), b.area_map.doors.size());
  for (std::size_t i = 0; i < a.area_map.doors.size(); ++i) {
    EXPECT_EQ(a.area_map.doors[i].jambs_map.a, b.area_map.doors[i].jambs_map.a);
    EXPECT_EQ(a.area_map.doors[i].confidence, b.area_map.doors[i].confidence);
  }
}

TEST(Pipeline, AnOriginMovesAndTurnsEverythingWithTheMap) {
  OccupancyGrid grid = office(3);
  const SemanticMap upright = annotated(grid);
  const Pose2 moved_from_map{{3, -8}, 0.5};
  grid.geometry.map_from_image = moved_from_map * grid.geometry.map_from_image;
  const SemanticMap moved = annotated(grid);
  // numbers go from the top of the map to its bottom, so they may differ: compare the places
  std::vector<Point2> anchors;
  for (const Area& area : moved.area_map.areas) anchors.push_back(area.anchor_map);
  ASSERT_EQ(anchors.size(), upright.area_map.areas.size());
  for (const Area& area : upright.area_map.areas) {
    EXPECT_LT(distanceToNearest(moved_from_map * area.anchor_map, anchors), 1e-6);
  }
  std::vector<Point2> jambs;
  for (const Door& door : moved.area_map.doors) {
    jambs.push_back(door.jambs_map.a);
    jambs.push_back(door.jambs_map.b);
  }
  ASSERT_EQ(jambs.size(), 2 * upright.area_map.doors.size());
  for (const Door& door : upright.area_map.doors) {
    EXPECT_LT(distanceToNearest(moved_from_map * door.jambs_map.a, jambs), 1e-6);
    EXPECT_LT(distanceToNearest(moved_from_map * door.jambs_map.b, jambs), 1e-6);
  }
}

TEST(Pipeline, AGivenNameStaysWithItsArea) {
  const OccupancyGrid grid = office(4);
  const SemanticMap before = annotated(grid);
  AreaTag tag;
  tag.id = AreaId{900};
  tag.name = "kitchen";
  tag.source = TagSource::kManual;
  tag.seed_map = before.area_map.areas.front().anchor_map;
  const SemanticMap after = annotated(grid, {tag});
  const Area* kitchen = areaAt(after, tag.seed_map);
  ASSERT_NE(kitchen, nullptr);
  EXPECT_EQ(kitchen->name, "kitchen");
  EXPECT_EQ(kitchen->id, AreaId{900});
  EXPECT_EQ(kitchen->source, TagSource::kManual);
  EXPECT_EQ(after.area_map.areas.size(), before.area_map.areas.size());
}

TEST(Pipeline, M4_TheSmallestMapsAreAccepted) {
  for (const auto& rows :
       {std::vector<std::string>{"."}, {"#"}, {"?"}, {"....."}, {".", "#", "."}}) {
    const SemanticMap map = annotated(test::asciiGrid(rows, 0.05));
    EXPECT_GE(map.grid().cellCount(), 1U);
    EXPECT_LE(map.area_map.areas.size(), 1U);
  }
}

TEST(Pipeline, M14_UniformMapsSayWhyThereIsNothing) {
  const std::vector<std::string> unknown(40, std::string(40, '?'));
  const std::vector<std::string> occupied(40, std::string(40, '#'));
  for (const auto& rows : {unknown, occupied}) {
    const SemanticMap map = annotated(test::asciiGrid(rows, 0.05));
    EXPECT_TRUE(map.area_map.areas.empty());
    EXPECT_FALSE(map.area_map.warnings.empty());
  }
  const std::vector<std::string> free(40, std::string(40, '.'));
  EXPECT_EQ(annotated(test::asciiGrid(free, 0.05)).area_map.areas.size(), 1U);
}

TEST(Pipeline, M15_NoiseGivesNoMoreCellsThanAllowedAndSaysSo) {
  PipelineParams params;
  params.grid.max_cells = 300;
  for (const double density : {0.01, 0.1, 0.3, 0.5}) {
    SCOPED_TRACE(density);
    const auto map = std::make_shared<const OccupancyMap>(test::noise(5, 400, 400, density));
    const Structure structure = extractStructure(map, params);
    EXPECT_LE(structure.grid->cellCount(), 300U);
    EXPECT_FALSE(structure.walls.warnings.empty());
    EXPECT_EQ(annotate(structure, {}, params).area_map.pixel_labels.size(), 160000U);
  }
}

/// A corridor of one pixel that winds to the middle, with walls of one pixel.
std::vector<std::string> spiral(int size) {
  std::vector<std::string> rows(static_cast<std::size_t>(size),
                                std::string(static_cast<std::size_t>(size), '#'));
  const auto at = [&](int x, int y) -> char& {
    return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  };
  const auto isFree = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < size && y < size && at(x, y) == '.';
  };
  int x = 1;
  int y = 1;
  int dx = 1;
  int dy = 0;
  at(x, y) = '.';
  for (int turns = 0; turns < 2;) {
    const bool blocked = x + dx <= 0 || y + dy <= 0 || x + dx >= size - 1 || y + dy >= size - 1 ||
                         isFree(x + 2 * dx, y + 2 * dy);
    if (blocked) {
      std::swap(dx, dy);
      dx = -dx;
      ++turns;
    } else {
      x += dx;
      y += dy;
      at(x, y) = '.';
      turns = 0;
    }
  }
  return rows;
}

TEST(Pipeline, M17_LongWindingsAndCheckerboardsNeedNoDeepStack) {
  const std::vector<std::string> winding = spiral(501);
  const auto free_of = [](const std::string& row) { return std::count(begin(row), end(row), '.'); };
  std::ptrdiff_t free = 0;
  for (const std::string& row : winding) free += free_of(row);
  ASSERT_GT(free, 501 * 501 * 2 / 5);
  // 0.3 m wide, so that it is no stray ray
  EXPECT_EQ(annotated(test::asciiGrid(winding, 0.3)).area_map.areas.size(), 1U);
  std::vector<std::string> board(500);
  for (std::size_t y = 0; y < board.size(); ++y) {
    for (std::size_t x = 0; x < 500; ++x) board[y] += (x + y) % 2 == 0 ? '.' : '#';
  }
  EXPECT_LE(annotated(test::asciiGrid(board, 0.3)).area_map.areas.size(), 1U);
}

}  // namespace
}  // namespace agrid
