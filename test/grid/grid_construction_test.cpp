// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/grid_construction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace agrid {
namespace {

std::vector<WallLine> randomLines(std::mt19937& random, double extent, int count) {
  std::set<double> offsets;
  // Quarters of a metre, so that gaps of exactly twice the smallest one occur.
  std::uniform_int_distribution<int> place(1, static_cast<int>(extent * 4) - 1);
  for (int i = 0; i < count; ++i) offsets.insert(place(random) / 4.0);
  std::vector<WallLine> lines;
  std::uniform_int_distribution<int> votes(1, 300);
  for (const double offset : offsets) lines.push_back({offset, votes(random)});
  return lines;
}

Walls randomWalls(std::mt19937& random) {
  std::uniform_int_distribution<int> size(1, 60);
  std::uniform_int_distribution<int> count(0, 12);
  Walls walls;
  walls.extent = Point2(size(random), size(random));
  walls.vertical = randomLines(random, walls.extent.x(), count(random));
  walls.horizontal = randomLines(random, walls.extent.y(), count(random));
  return walls;
}

/// Alg. 2 as it is printed, for the lines of one direction.
std::vector<double> printedAlgorithm(std::vector<double> walls, double map_size) {
  std::set<double> grid;
  std::vector<std::pair<double, double>> queue;
  double min_gap = map_size;
  for (const double w1 : walls) {
    double segment_dist = map_size;
    double second_line = std::numeric_limits<double>::quiet_NaN();
    for (const double w2 : walls) {
      if (w1 - w2 > 0 && w1 - w2 <= segment_dist) {
        second_line = w2;
        segment_dist = w1 - w2;
      }
    }
    if (!std::isnan(second_line)) {
      queue.emplace_back(w1, second_line);
      min_gap = std::min(min_gap, segment_dist);
    }
    grid.insert(w1);
  }
  while (!queue.empty()) {
    const auto [first_line, second_line] = queue.back();
    queue.pop_back();
    if (std::abs(first_line - second_line) / min_gap >= 2) {
      const double new_line = (first_line + second_line) / 2;
      grid.insert(new_line);
      queue.emplace_back(first_line, new_line);
      queue.emplace_back(new_line, second_line);
    }
  }
  return {grid.begin(), grid.end()};
}

std::vector<double> withEdges(const std::vector<WallLine>& walls, double extent) {
  std::vector<double> lines{0};
  for (const WallLine& wall : walls) lines.push_back(wall.offset);
  lines.push_back(extent);
  return lines;
}

void expectNear(const std::vector<double>& actual, const std::vector<double>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-9);
}

TEST(GridConstruction, EqualsThePrintedAlgorithm) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const Walls walls = randomWalls(random);
    const AGrid grid = constructGrid(walls);
    expectNear(grid.x(), printedAlgorithm(withEdges(walls.vertical, walls.extent.x()), 1e9));
    expectNear(grid.y(), printedAlgorithm(withEdges(walls.horizontal, walls.extent.y()), 1e9));
  }
}

void expectProperties(const std::vector<double>& edges, const std::vector<WallLine>& walls,
                      double extent) {
  EXPECT_EQ(edges.front(), 0);
  EXPECT_EQ(edges.back(), extent);
  const std::vector<double> lines = withEdges(walls, extent);
  double min_gap = extent;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    min_gap = std::min(min_gap, lines[i] - lines[i - 1]);
  }
  for (const WallLine& wall : walls) {
    EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), wall.offset)) << wall.offset;
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    EXPECT_GE(edges[i] - edges[i - 1], min_gap * (1 - 1e-8));
    EXPECT_LT(edges[i] - edges[i - 1], 2 * min_gap);
  }
}

TEST(GridConstruction, TilesTheBoundsWithGapsBetweenOnceAndTwiceTheSmallest) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const Walls walls = randomWalls(random);
    const AGrid grid = constructGrid(walls);
    expectProperties(grid.x(), walls.vertical, walls.extent.x());
    expectProperties(grid.y(), walls.horizontal, walls.extent.y());
    EXPECT_EQ(countCells(walls), static_cast<double>(grid.cellCount()));
  }
}

TEST(GridConstruction, MultiplesInPixelsStayMultiplesInMetres) {
  Walls walls;
  walls.extent = Point2(400 * 0.05, 1);
  for (const int x : {8, 16, 32, 64, 128, 256}) walls.vertical.push_back({x * 0.05, 10});
  EXPECT_EQ(constructGrid(walls).columns(), 2 + 2 + 4 + 8 + 16 + 16);
}

TEST(GridConstruction, NoWallsGiveOneCellAndOneWallTwoColumns) {
  Walls walls;
  walls.extent = Point2(5, 3);
  EXPECT_EQ(constructGrid(walls).cellCount(), 1U);
  walls.vertical = {{2, 9}};
  EXPECT_EQ(constructGrid(walls).x(), std::vector<double>({0, 2, 5}));
  EXPECT_EQ(constructGrid(walls).y(), std::vector<double>({0, 3}));
}

TEST(GridConstruction, AWallOnAnEdgeOfTheMapIsThatEdge) {
  Walls walls;
  walls.extent = Point2(4, 4);
  walls.vertical = {{0, 1}, {2, 1}, {4, 1}};
  EXPECT_EQ(constructGrid(walls).x(), std::vector<double>({0, 2, 4}));
}

TEST(GridConstruction, RefusesWallsOutsideTheExtentOrOutOfOrder) {
  Walls walls;
  walls.extent = Point2(4, 4);
  walls.vertical = {{5, 1}};
  EXPECT_THROW(constructGrid(walls), std::invalid_argument);
  walls.vertical = {{2, 1}, {1, 1}};
  EXPECT_THROW(constructGrid(walls), std::invalid_argument);
  walls.vertical = {{std::nan(""), 1}};
  EXPECT_THROW(constructGrid(walls), std::invalid_argument);
  walls.vertical.clear();
  walls.extent = Point2(0, 4);
  EXPECT_THROW(constructGrid(walls), std::invalid_argument);
}

TEST(GridConstruction, FewerThanTheLimitAreLeftAlone) {
  std::mt19937 random(9);
  const Walls walls = randomWalls(random);
  const Walls limited = limitCells(walls, {countCells(walls)});
  EXPECT_EQ(limited.vertical.size(), walls.vertical.size());
  EXPECT_TRUE(limited.warnings.empty());
}

TEST(GridConstruction, M15_TheWeakestLinesGoWhereCellsAreTooMany) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 50; ++trial) {
    Walls walls = randomWalls(random);
    const double limit = std::max(1.0, countCells(walls) / 3);
    const Walls limited = limitCells(walls, {limit});
    EXPECT_LE(countCells(limited), limit);
    if (countCells(walls) <= limit) continue;
    EXPECT_EQ(limited.warnings.size(), 1U);
    int weakest_kept = 1000;
    for (const auto* axis : {&limited.vertical, &limited.horizontal}) {
      for (const WallLine& line : *axis) weakest_kept = std::min(weakest_kept, line.votes);
    }
    const auto stronger = [&](const WallLine& line) { return line.votes > weakest_kept; };
    EXPECT_EQ(std::count_if(walls.vertical.begin(), walls.vertical.end(), stronger),
              std::count_if(limited.vertical.begin(), limited.vertical.end(), stronger));
  }
  EXPECT_THROW(limitCells({}, {0}), std::invalid_argument);
}

}  // namespace
}  // namespace agrid
