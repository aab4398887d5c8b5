// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_labels.h"

#include <algorithm>
#include <optional>

namespace agrid {
namespace {

/// Pixels of one label that follow each other in a row of the map and lie in one cell.
struct Run {
  std::uint32_t cell = 0;
  std::uint16_t label = 0;
  std::uint32_t length = 0;
};

/// A cell of the grid as it was found last; neighbouring pixels mostly share it.
struct LastCell {
  std::uint32_t index = 0;
  Point2 low = Point2::Constant(1);
  Point2 high = Point2::Zero();  ///< an empty cell to begin with

  bool holds(const Point2& p) const {
    return p.x() >= low.x() && p.y() >= low.y() && p.x() < high.x() && p.y() < high.y();
  }
};

std::optional<LastCell> findCell(const AGrid& grid, const Point2& point_grid) {
  const auto cell = grid.cellAtGridPoint(point_grid);
  if (!cell) return std::nullopt;
  const auto column = static_cast<std::size_t>(cell->column);
  const auto row = static_cast<std::size_t>(cell->row);
  return LastCell{static_cast<std::uint32_t>(grid.index(*cell)),
                  {grid.x()[column], grid.y()[row]},
                  {grid.x()[column + 1], grid.y()[row + 1]}};
}

std::vector<Run> collectRuns(const AGrid& grid, const MapGeometry& geometry,
                             const std::vector<std::uint16_t>& pixel_labels) {
  std::vector<Run> runs;
  const Pose2 grid_from_map = inverse(grid.mapFromGrid());
  const Point2 origin = grid_from_map * geometry.center({0, 0});
  const Point2 step_x = grid_from_map * geometry.center({1, 0}) - origin;
  const Point2 step_y = grid_from_map * geometry.center({0, 1}) - origin;
  LastCell cell;
  for (int y = 0; y < geometry.height; ++y) {
    const std::size_t first = geometry.index({0, y});
    runs.push_back({});  // no run goes on from the row before
    for (int x = 0; x < geometry.width; ++x) {
      const std::uint16_t label = pixel_labels[first + static_cast<std::size_t>(x)];
      if (label == 0) continue;
      const Point2 point = origin + step_x * x + step_y * y;
      if (!cell.holds(point)) {
        const auto found = findCell(grid, point);
        if (!found) continue;
        cell = *found;
      }
      if (runs.back().label == label && runs.back().cell == cell.index) {
        ++runs.back().length;
      } else {
        runs.push_back({cell.index, label, 1});
      }
    }
  }
  return runs;
}

}  // namespace

std::vector<AreaId> labelCells(const AGrid& grid, const MapGeometry& geometry,
                               const std::vector<std::uint16_t>& pixel_labels,
                               const std::vector<Area>& areas) {
  std::vector<Run> runs = collectRuns(grid, geometry, pixel_labels);
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.label < b.label;
  });
  std::vector<AreaId> cells(grid.cellCount(), AreaId{0});
  std::vector<std::uint64_t> most(grid.cellCount(), 0);
  for (std::size_t begin = 0, end = 0; begin < runs.size(); begin = end) {
    const Run& run = runs[begin];
    std::uint64_t pixels = 0;
    while (end < runs.size() && runs[end].cell == run.cell && runs[end].label == run.label) {
      pixels += runs[end++].length;
    }
    if (run.label == 0 || pixels <= most[run.cell]) continue;
    most[run.cell] = pixels;
    cells[run.cell] = areas[run.label - 1U].id;
  }
  return cells;
}

std::vector<std::uint32_t> cellsOnSegment(const AGrid& grid, const Segment& segment_map) {
  const Pose2 grid_from_map = inverse(grid.mapFromGrid());
  const Point2 a = grid_from_map * segment_map.a;
  const Point2 b = grid_from_map * segment_map.b;
  std::vector<double> crossings{0, 1};
  const auto cross = [&](const std::vector<double>& edges, double from, double to) {
    const auto begin = std::lower_bound(edges.begin(), edges.end(), std::min(from, to));
    const auto end = std::upper_bound(begin, edges.end(), std::max(from, to));
    for (auto edge = begin; edge != end && from != to; ++edge) {
      crossings.push_back((*edge - from) / (to - from));
    }
  };
  cross(grid.x(), a.x(), b.x());
  cross(grid.y(), a.y(), b.y());
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::uint32_t> cells;
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const double middle = (crossings[i - 1] + crossings[i]) / 2;
    if (const auto cell = grid.cellAtGridPoint(a + (b - a) * middle)) {
      cells.push_back(static_cast<std::uint32_t>(grid.index(*cell)));
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace agrid
