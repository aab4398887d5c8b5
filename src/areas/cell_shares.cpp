// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_shares.h"

#include <algorithm>

#include "areas/pixel_raster.h"
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

std::vector<Run> collectRuns(const AGrid& grid, const MapGeometry& geometry,
                             const PixelLabels& labels) {
  std::vector<Run> runs;
  const PixelRaster raster(grid, geometry);
  CellCursor cell(grid);
  std::vector<std::uint16_t> row;
  for (int y = 0; y < geometry.height; ++y) {
    labels.copy(geometry.index({0, y}), static_cast<std::size_t>(geometry.width), row);
    forEachRun(row.data(), geometry.width, [&](int begin, int end, std::uint16_t label) {
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

CellShares::CellShares(const AGrid& grid, const MapGeometry& geometry, const PixelLabels& labels,
                       std::size_t label_count)
    : first_(grid.cellCount() + 1), cells_of_(label_count) {
  std::vector<Run> runs = collectRuns(grid, geometry, labels);
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.label < b.label;
  });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    if (i > 0 && runs[i - 1].cell == run.cell && runs[i - 1].label == run.label) {
      shares_.back().pixels += run.length;
      continue;
    }
    shares_.push_back({run.label, run.length});
    ++first_[run.cell + 1];
    cells_of_[run.label - 1U].push_back(run.cell);
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
}

}  // namespace agrid
