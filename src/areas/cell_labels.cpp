// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_labels.h"

#include <algorithm>

#include "tags/pixel_runs.h"

namespace agrid {
namespace {

/// Pixels of one label that follow each other in a row of the map and lie in one cell.
struct Run {
  std::uint32_t cell = 0;
  std::uint16_t label = 0;
  std::uint32_t length = 0;
};

/// A cell of the grid that follows a point; from one cell to the next it is a step.
class CellCursor {
 public:
  explicit CellCursor(const AGrid& grid) : grid_(grid) {}

  /// Moves to the cell that holds a point of the grid's frame; false if none does.
  bool moveTo(const Point2& p) {
    if (!isWithin(grid_.x(), p.x()) || !isWithin(grid_.y(), p.y())) return false;
    move(grid_.x(), p.x(), column_);
    move(grid_.y(), p.y(), row_);
    return true;
  }
  bool holds(const Point2& p) const {
    return p.x() >= grid_.x()[column_] && p.y() >= grid_.y()[row_] &&
           p.x() < grid_.x()[column_ + 1] && p.y() < grid_.y()[row_ + 1];
  }
  std::uint32_t index() const {
    return static_cast<std::uint32_t>(
        grid_.index({static_cast<int>(row_), static_cast<int>(column_)}));
  }

 private:
  static bool isWithin(const std::vector<double>& edges, double value) {
    return value >= edges.front() && value < edges.back();
  }
  static void move(const std::vector<double>& edges, double value, std::size_t& i) {
    while (value < edges[i]) --i;
    while (value >= edges[i + 1]) ++i;
  }

  const AGrid& grid_;
  std::size_t column_ = 0;
  std::size_t row_ = 0;
};

/// The first of the numbers from `begin` to `end` for which `holds` is false, or `end`; it is true
/// for `begin`, and once false stays so.
template <typename Predicate>
int findEnd(int begin, int end, Predicate holds) {
  int step = 1;
  while (begin + step < end && holds(begin + step)) {
    begin += step;
    step *= 2;
  }
  end = std::min(begin + step, end);
  while (end - begin > 1) {
    const int middle = begin + (end - begin) / 2;
    (holds(middle) ? begin : end) = middle;
  }
  return end;
}

/// From the grid's point of view: where the centre of pixel (0, 0) lies and how far it is from
/// there to the next column and row.
struct PixelRaster {
  Point2 origin;
  Point2 step_x;
  Point2 step_y;

  PixelRaster(const AGrid& grid, const MapGeometry& geometry) {
    const Pose2 grid_from_map = inverse(grid.mapFromGrid());
    origin = grid_from_map * geometry.center({0, 0});
    step_x = grid_from_map * geometry.center({1, 0}) - origin;
    step_y = grid_from_map * geometry.center({0, 1}) - origin;
  }
  Point2 center(int x, int y) const { return origin + step_x * x + step_y * y; }
};

std::vector<Run> collectRuns(const AGrid& grid, const MapGeometry& geometry,
                             const std::vector<std::uint16_t>& pixel_labels) {
  std::vector<Run> runs;
  const PixelRaster raster(grid, geometry);
  CellCursor cell(grid);
  for (int y = 0; y < geometry.height; ++y) {
    const std::uint16_t* row = pixel_labels.data() + geometry.index({0, y});
    forEachRun(row, geometry.width, [&](int begin, int end, std::uint16_t label) {
      for (int x = begin; label != 0 && x < end;) {
        if (!cell.moveTo(raster.center(x, y))) {
          ++x;
          continue;
        }
        const int next = findEnd(x, end, [&](int i) { return cell.holds(raster.center(i, y)); });
        runs.push_back({cell.index(), label, static_cast<std::uint32_t>(next - x)});
        x = next;
      }
    });
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
    if (pixels <= most[run.cell]) continue;
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
