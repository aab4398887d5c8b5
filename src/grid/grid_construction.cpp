// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/grid_construction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace agrid {
namespace {

// Gaps that are whole multiples of each other in pixels must stay so in metres.
constexpr double kRoundOff = 1e-9;

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
double partsOf(double gap, double min_gap) {
  double parts = 1;
  while (gap / parts >= 2 * min_gap * (1 - kRoundOff)) parts *= 2;
  return parts;
}

/// Alg. 2, lines 15 to 27: halving a gap until it is small splits it into equal parts.
std::vector<double> refine(const std::vector<double>& lines) {
  const double min_gap = smallestGap(lines);
  std::vector<double> refined{lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double gap = lines[i] - lines[i - 1];
    const double parts = partsOf(gap, min_gap);
    for (double part = 1; part < parts; ++part) {
      refined.push_back(lines[i - 1] + gap * part / parts);
    }
    refined.push_back(lines[i]);
  }
  return refined;
}

double countGaps(const std::vector<double>& lines) {
  const double min_gap = smallestGap(lines);
  double count = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) count += partsOf(lines[i] - lines[i - 1], min_gap);
  return count;
}

std::vector<double> linesX(const Walls& walls) {
  return linesOf(walls.vertical, walls.extent.x(), "vertical");
}

std::vector<double> linesY(const Walls& walls) {
  return linesOf(walls.horizontal, walls.extent.y(), "horizontal");
}

/// The walls without their `count` weakest lines.
Walls withoutWeakest(const Walls& walls, std::size_t count) {
  std::vector<std::tuple<int, int, double>> ranking;  // votes, axis, offset
  for (const WallLine& line : walls.vertical) ranking.emplace_back(line.votes, 0, line.offset);
  for (const WallLine& line : walls.horizontal) ranking.emplace_back(line.votes, 1, line.offset);
  std::sort(ranking.begin(), ranking.end());
  Walls kept = walls;
  kept.vertical.clear();
  kept.horizontal.clear();
  for (std::size_t i = count; i < ranking.size(); ++i) {
    const auto& [votes, axis, offset] = ranking[i];
    (axis == 0 ? kept.vertical : kept.horizontal).push_back({offset, votes});
  }
  const auto by_offset = [](const WallLine& a, const WallLine& b) { return a.offset < b.offset; };
  std::sort(kept.vertical.begin(), kept.vertical.end(), by_offset);
  std::sort(kept.horizontal.begin(), kept.horizontal.end(), by_offset);
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
  const std::size_t lines = walls.vertical.size() + walls.horizontal.size();
  std::size_t too_few = 0;
  std::size_t enough = lines;  // without walls there is one cell
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    const bool fits = countCells(withoutWeakest(walls, middle)) <= params.max_cells;
    (fits ? enough : too_few) = middle;
  }
  Walls kept = withoutWeakest(walls, enough);
  kept.warnings.push_back("the grid would have more than " +
                          std::to_string(static_cast<long long>(params.max_cells)) +
                          " cells: the " + std::to_string(enough) + " weakest of " +
                          std::to_string(lines) + " wall lines were dropped");
  return kept;
}

}  // namespace agrid
