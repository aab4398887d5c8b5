// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/grid_construction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "grid/spaced_lines.h"

namespace agrid {
namespace {

// Gaps that are whole multiples of each other in pixels must stay so in metres.
constexpr double kRoundOff = 1e-9;
constexpr int kDistanceBits = 40;  // of the distance that limitCells looks for

/// The wall lines of an axis and the two edges of the map, strictly increasing.
std::vector<double> linesOf(const std::vector<WallLine>& walls, double extent,
                            const std::string& axis) {
  if (!(extent > 0 && std::isfinite(extent))) {
    throw std::invalid_argument("Walls.extent: " + std::to_string(extent) + " is not above 0");
  }
  std::vector<double> lines{0};
  for (const WallLine& wall : walls) {
    const bool in_order = wall.offset >= lines.back() && wall.offset <= extent;
    if (!in_order) {
      throw std::invalid_argument("Walls." + axis + ": offset " + std::to_string(wall.offset) +
                                  " is out of order or not in [0, " + std::to_string(extent) + "]");
    }
    if (wall.offset > lines.back()) lines.push_back(wall.offset);
  }
  if (extent > lines.back()) lines.push_back(extent);
  return lines;
}

double smallestGap(const std::vector<double>& lines) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    smallest = std::min(smallest, lines[i] - lines[i - 1]);
  }
  return smallest;
}

/// Into how many parts halving splits a gap, until each part is smaller than twice `min_gap`.
std::int64_t partsOf(double gap, double min_gap) {
  std::int64_t parts = 1;
  while (gap / static_cast<double>(parts) >= 2 * min_gap * (1 - kRoundOff)) parts *= 2;
  return parts;
}

/// Alg. 2, lines 15 to 27: halving a gap until it is small splits it into equal parts.
std::vector<double> refine(const std::vector<double>& lines) {
  const double min_gap = smallestGap(lines);
  std::vector<double> refined{lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double gap = lines[i] - lines[i - 1];
    const std::int64_t parts = partsOf(gap, min_gap);
    for (std::int64_t part = 1; part < parts; ++part) {
      refined.push_back(lines[i - 1] +
                        gap * static_cast<double>(part) / static_cast<double>(parts));
    }
    refined.push_back(lines[i]);
  }
  return refined;
}

double countGaps(const std::vector<double>& lines) {
  const double min_gap = smallestGap(lines);
  double count = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    count += static_cast<double>(partsOf(lines[i] - lines[i - 1], min_gap));
  }
  return count;
}

std::vector<double> linesX(const Walls& walls) {
  return linesOf(walls.vertical, walls.extent.x(), "vertical");
}

std::vector<double> linesY(const Walls& walls) {
  return linesOf(walls.horizontal, walls.extent.y(), "horizontal");
}

/// The lines of an axis that lie at least `distance` from the edges and from all stronger lines.
std::vector<WallLine> thinOut(std::vector<WallLine> lines, double extent, double distance) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const WallLine& a, const WallLine& b) { return a.votes > b.votes; });
  SpacedLines kept(extent);
  for (const WallLine& line : lines) kept.addIfFar(line, distance);
  return kept.lines();
}

Walls thinOut(const Walls& walls, double distance) {
  Walls kept = walls;
  kept.vertical = thinOut(walls.vertical, walls.extent.x(), distance);
  kept.horizontal = thinOut(walls.horizontal, walls.extent.y(), distance);
  return kept;
}

}  // namespace

AGrid constructGrid(const Walls& walls) {
  return {walls.map_from_grid, refine(linesX(walls)), refine(linesY(walls))};
}

double countCells(const Walls& walls) {
  return countGaps(linesX(walls)) * countGaps(linesY(walls));
}

Walls limitCells(Walls walls, const GridParams& params) {
  if (!(params.max_cells >= 1)) {
    throw std::invalid_argument("GridParams.max_cells: " + std::to_string(params.max_cells) +
                                " is below 1");
  }
  if (countCells(walls) <= params.max_cells) return walls;
  double too_close = 0;
  double far_enough = walls.extent.maxCoeff();  // without walls there is one cell
  for (int i = 0; i < kDistanceBits; ++i) {
    const double middle = too_close + (far_enough - too_close) / 2;
    const bool fits = countCells(thinOut(walls, middle)) <= params.max_cells;
    (fits ? far_enough : too_close) = middle;
  }
  Walls kept = thinOut(walls, far_enough);
  const std::size_t lines = walls.vertical.size() + walls.horizontal.size();
  const std::size_t dropped = lines - kept.vertical.size() - kept.horizontal.size();
  kept.warnings.push_back("the grid would have more than " +
                          std::to_string(static_cast<long long>(params.max_cells)) +
                          " cells: " + std::to_string(dropped) + " of " + std::to_string(lines) +
                          " wall lines were dropped, each for a stronger one beside it");
  return kept;
}

}  // namespace agrid
