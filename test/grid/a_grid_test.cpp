// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/a_grid.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace agrid {
namespace {

std::vector<double> randomEdges(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> gap(0.01, 2);
  std::vector<double> edges{std::uniform_real_distribution<double>(-5, 5)(random)};
  while (static_cast<int>(edges.size()) <= count) edges.push_back(edges.back() + gap(random));
  return edges;
}

/// The cell of a point by looking at all of them.
std::optional<Cell> cellByScan(const AGrid& grid, const Point2& point_grid) {
  for (int r = 0; r < grid.rows(); ++r) {
    for (int c = 0; c < grid.columns(); ++c) {
      const auto row = static_cast<std::size_t>(r);
      const auto column = static_cast<std::size_t>(c);
      const bool last_row = r + 1 == grid.rows();
      const bool last_column = c + 1 == grid.columns();
      const double x1 = grid.x()[column + 1];
      const double y1 = grid.y()[row + 1];
      const bool in_x = grid.x()[column] <= point_grid.x() &&
                        (point_grid.x() < x1 || (last_column && point_grid.x() == x1));
      const bool in_y = grid.y()[row] <= point_grid.y() &&
                        (point_grid.y() < y1 || (last_row && point_grid.y() == y1));
      if (in_x && in_y) return Cell{r, c};
    }
  }
  return std::nullopt;
}

TEST(AGrid, RefusesEdgesThatDoNotIncrease) {
  EXPECT_THROW(AGrid({}, {0}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(AGrid({}, {0, 1}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(AGrid({}, {0, std::nan("")}, {0, 1}), std::invalid_argument);
}

TEST(AGrid, CellCentersReturnToTheirCellsAtAnyPose) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    std::uniform_real_distribution<double> value(-10, 10);
    const AGrid grid({{value(random), value(random)}, value(random)}, randomEdges(random, 12),
                     randomEdges(random, 9));
    for (std::size_t i = 0; i < grid.cellCount(); ++i) {
      const auto found = grid.cellAt(grid.cellCenter(grid.cell(i)));
      ASSERT_TRUE(found);
      EXPECT_EQ(grid.index(*found), i);
    }
  }
}

TEST(AGrid, FindsTheSameCellAsAScanOfAllCells) {
  std::mt19937 random(11);
  const AGrid grid({}, randomEdges(random, 8), randomEdges(random, 6));
  std::uniform_real_distribution<double> value(-8, 20);
  for (int i = 0; i < 10000; ++i) {
    const Point2 point(value(random), value(random));
    EXPECT_TRUE(grid.cellAtGridPoint(point) == cellByScan(grid, point)) << point.transpose();
  }
}

TEST(AGrid, BordersBelongToTheUpperCellAndTheOuterEdgeToTheLast) {
  const AGrid grid({}, {0, 1, 3}, {0, 2});
  EXPECT_TRUE(grid.cellAtGridPoint({1, 0}) == Cell({0, 1}));
  EXPECT_TRUE(grid.cellAtGridPoint({3, 2}) == Cell({0, 1}));
  EXPECT_FALSE(grid.cellAtGridPoint({3.0001, 1}));
  EXPECT_FALSE(grid.cellAtGridPoint({std::numeric_limits<double>::quiet_NaN(), 1}));
}

}  // namespace
}  // namespace agrid
