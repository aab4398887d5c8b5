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

double smallestGap(const std::vector<double>& lines) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    smallest = std::min(smallest, lines[i] - lines[i - 1]);
  }
  return smallest;
}

/// Each line that is gone lies nearer to an edge or to a stronger line that stayed than those that
/// stayed lie to each other on the axis where they are closest.
void expectOnlyWeakLinesGone(const std::vector<WallLine>& before,
                             const std::vector<WallLine>& after, double extent, double distance) {
  for (const WallLine& line : before) {
    const bool stayed = std::any_of(after.begin(), after.end(), [&](const WallLine& kept) {
      return kept.offset == line.offset;
    });
    const bool is_beside_stronger =
        std::any_of(after.begin(), after.end(), [&](const WallLine& kept) {
          return kept.votes >= line.votes && std::abs(kept.offset - line.offset) < distance;
        });
    const bool is_beside_edge = std::min(line.offset, extent - line.offset) < distance;
    EXPECT_TRUE(stayed || is_beside_stronger || is_beside_edge) << line.offset;
  }
}

TEST(GridConstruction, M15_WeakLinesBesideStrongOnesGoWhereCellsAreTooMany) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const Walls walls = randomWalls(random);
    const double limit = std::max(1.0, countCells(walls) / 3);
    const Walls limited = limitCells(walls, {limit});
    EXPECT_LE(countCells(limited), limit);
    if (countCells(walls) <= limit) continue;
    ASSERT_EQ(limited.warnings.size(), 1U);
    double distance = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
      const auto& kept = axis == 0 ? limited.vertical : limited.horizontal;
      if (!kept.empty()) {
        distance = std::min(distance, smallestGap(withEdges(kept, walls.extent[axis])));
      }
    }
    expectOnlyWeakLinesGone(walls.vertical, limited.vertical, walls.extent.x(), distance);
    expectOnlyWeakLinesGone(walls.horizontal, limited.horizontal, walls.extent.y(), distance);
  }
  EXPECT_THROW(limitCells({}, {0}), std::invalid_argument);
}

TEST(GridConstruction, M15_HalfTheCellsCostFewLines) {
  std::mt19937 random(29);
  std::uniform_int_distribution<int> gap(5, 60);
  std::uniform_int_distribution<int> votes(20, 900);
  Walls walls;
  walls.extent = Point2(2000, 2000);
  for (double x = gap(random); x < 1995; x += gap(random))
    walls.vertical.push_back({x, votes(random)});
  for (double y = gap(random); y < 1995; y += gap(random))
    walls.horizontal.push_back({y, votes(random)});
  const Walls limited = limitCells(walls, {countCells(walls) / 2});
  EXPECT_GT(limited.vertical.size(), walls.vertical.size() * 8 / 10);
  EXPECT_GT(limited.horizontal.size(), walls.horizontal.size() * 8 / 10);
}

}  // namespace
}  // namespace agrid
