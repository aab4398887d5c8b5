// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/object_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/two_rooms.h"

namespace agrid {
namespace {

using Cells = std::vector<std::uint32_t>;

/// Edges 0, 1, 3, 6 along x and 0, 2, 3 along y, so that cell (r, c) has the index 3 r + c.
SemanticMap threeByTwo(const Pose2& map_from_grid = {}) {
  SemanticMap map = test::twoRooms();
  map.structure.grid = std::make_shared<const AGrid>(map_from_grid, std::vector<double>{0, 1, 3, 6},
                                                     std::vector<double>{0, 2, 3});
  return map;
}

ObjectTag box(const Pose2& pose_map, const Point2& size) {
  ObjectTag object;
  object.name = "fridge";
  object.category = "appliance";
  object.pose_map = pose_map;
  object.size = size;
  return object;
}

TEST(ObjectCells, ABoxIsInTheCellsThatItOverlaps) {
  const SemanticMap map = threeByTwo();
  EXPECT_EQ(cellsOf(map, box({{2, 1}, 0}, {1, 1})), (Cells{1}));
  EXPECT_EQ(cellsOf(map, box({{2, 1}, 0}, {2.5, 1})), (Cells{0, 1, 2}));
  EXPECT_EQ(cellsOf(map, box({{1, 2}, 0}, {0.5, 0.5})), (Cells{0, 1, 3, 4}));
  EXPECT_EQ(cellsOf(map, box({{3, 1.5}, 0}, {100, 100})), (Cells{0, 1, 2, 3, 4, 5}));
}

TEST(ObjectCells, ABoxThatTouchesASideIsNotBeyondIt) {
  const SemanticMap map = threeByTwo();
  EXPECT_EQ(cellsOf(map, box({{2, 1}, 0}, {2, 2})), (Cells{1}));
  EXPECT_TRUE(cellsOf(map, box({{-1, 1}, 0}, {2, 2})).empty());
  EXPECT_TRUE(cellsOf(map, box({{7, 1}, 0}, {2, 2})).empty());
}

TEST(ObjectCells, WithoutASizeAnObjectIsAPoint) {
  const SemanticMap map = threeByTwo();
  for (const Point2& point : {Point2(0.5, 0.5), Point2(1, 2), Point2(6, 3), Point2(3, 0)}) {
    const auto cell = map.grid().cellAt(point);
    ASSERT_TRUE(cell);
    EXPECT_EQ(cellsOf(map, box({point, 0.4}, {0, 0})),
              (Cells{static_cast<std::uint32_t>(map.grid().index(*cell))}));
  }
  EXPECT_TRUE(cellsOf(map, box({{6.01, 1}, 0}, {0, 0})).empty());
}

TEST(ObjectCells, WithoutADepthAnObjectIsALine) {
  const SemanticMap map = threeByTwo();
  EXPECT_EQ(cellsOf(map, box({{2, 1}, 0}, {2.5, 0})), (Cells{0, 1, 2}));
  EXPECT_EQ(cellsOf(map, box({{2, 2}, 0}, {2.5, 0})), (Cells{3, 4, 5}));
  EXPECT_EQ(cellsOf(map, box({{2, 1.5}, std::acos(-1.) / 2}, {1.2, 0})), (Cells{1, 4}));
}

TEST(ObjectCells, ATurnedBoxLeavesOutTheCornersOfItsSurroundings) {
  const SemanticMap map = threeByTwo();
  // its corner points at (1, 2), where four cells meet, and does not get there
  EXPECT_EQ(cellsOf(map, box({{1.5, 1.2}, std::atan(0.8 / 0.5)}, {1.2, 0.5})), (Cells{0, 1}));
  EXPECT_EQ(cellsOf(map, box({{2, 1}, std::acos(-1.) / 4}, {1.2, 1.2})), (Cells{1}));
}

TEST(ObjectCells, WhatIsNotFiniteIsNowhere) {
  const SemanticMap map = threeByTwo();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(cellsOf(map, box({{nan, 1}, 0}, {1, 1})).empty());
  EXPECT_TRUE(cellsOf(map, box({{2, 1}, nan}, {1, 1})).empty());
  EXPECT_TRUE(cellsOf(map, box({{2, 1}, 0}, {1, nan})).empty());
  EXPECT_TRUE(cellsOf(map, box({{2, 1}, 0}, {1, INFINITY})).empty());
}

/// The cells that hold one of many points of a box.
std::set<std::uint32_t> cellsOfPoints(const AGrid& grid, const ObjectTag& object) {
  constexpr int kSteps = 150;
  std::set<std::uint32_t> cells;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Point2 share((i + 0.5) / kSteps - 0.5, (j + 0.5) / kSteps - 0.5);
      const auto cell = grid.cellAt(object.pose_map * Point2(object.size.cwiseProduct(share)));
      if (cell) cells.insert(static_cast<std::uint32_t>(grid.index(*cell)));
    }
  }
  return cells;
}

TEST(ObjectCells, TurnedBoxesOnTurnedGridsAreWhereTheirPointsAre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 300; ++round) {
    const SemanticMap map = threeByTwo({{unit(random) * 9, unit(random)}, unit(random) * 7 - 3.5});
    const Pose2 in_grid{{unit(random) * 8 - 1, unit(random) * 5 - 1}, unit(random) * 7 - 3.5};
    const Point2 size(unit(random) * 3 + 0.1, unit(random) * 3 + 0.1);
    const ObjectTag object = box(map.grid().mapFromGrid() * in_grid, size);
    const Cells cells = cellsOf(map, object);
    const std::set<std::uint32_t> found(cells.begin(), cells.end());
    EXPECT_EQ(found.size(), cells.size());
    EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
    // points leave out what is thinner than their distance: a slightly larger box has no less
    ObjectTag larger = object;
    larger.size *= 1.03;
    const auto inner = cellsOfPoints(map.grid(), object);
    const auto outer = cellsOfPoints(map.grid(), larger);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), inner.begin(), inner.end()));
    EXPECT_TRUE(std::includes(outer.begin(), outer.end(), found.begin(), found.end()));
    for (std::uint32_t i = 0; i < 6; ++i) {
      EXPECT_EQ(overlaps(map.grid(), object, map.grid().cell(i)), found.count(i) == 1);
    }
  }
}

TEST(ObjectCells, NameAndCategoryHoldInAllOfThem) {
  SemanticMap map = test::twoRooms();
  const auto here = [](const std::vector<std::string>& symbols, const std::string& name) {
    return std::count(symbols.begin(), symbols.end(), name) == 1;
  };
  EXPECT_TRUE(here(symbolsAt(map, {1, 3}), "fridge"));
  EXPECT_FALSE(here(symbolsAt(map, {1, 2}), "fridge"));
  map.knowledge.objects[0].size = {6, 0.6};
  for (const int column : {2, 3}) {
    EXPECT_TRUE(here(symbolsAt(map, {1, column}), "fridge")) << column;
    EXPECT_TRUE(here(symbolsAt(map, {1, column}), "appliance")) << column;
  }
  EXPECT_FALSE(here(symbolsAt(map, {1, 0}), "fridge"));
}

}  // namespace
}  // namespace agrid
