// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_labels.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

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

/// Corners of a rectangle and what encloses them in another frame.
struct Bounds {
  Point2 low;
  Point2 high;
};

/// @param frame_from_box  rotation and shift
Bounds enclose(const Pose2& frame_from_box, const Point2& low, const Point2& high) {
  Bounds bounds{frame_from_box * low, frame_from_box * low};
  for (const Point2& corner : {high, Point2(low.x(), high.y()), Point2(high.x(), low.y())}) {
    const Point2 p = frame_from_box * corner;
    bounds.low = bounds.low.cwiseMin(p);
    bounds.high = bounds.high.cwiseMax(p);
  }
  return bounds;
}

/// Positions of the intervals between edges that a range may meet: [first, second).
std::pair<std::size_t, std::size_t> intervals(const std::vector<double>& edges, double low,
                                              double high) {
  const auto count = static_cast<std::ptrdiff_t>(edges.size()) - 1;
  const auto first = std::upper_bound(edges.begin(), edges.end(), low) - edges.begin() - 2;
  const auto last = std::upper_bound(edges.begin(), edges.end(), high) - edges.begin() + 1;
  return {static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(first, 0, count)),
          static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(last, 0, count))};
}

/// Adds the cells that a box of pixels may meet.
void addCells(const AGrid& grid, const MapGeometry& geometry, const cv::Rect& box,
              std::set<std::size_t>& cells) {
  const double r = geometry.resolution;
  const Bounds bounds = enclose(inverse(grid.mapFromGrid()) * geometry.map_from_image,
                                Point2(box.x, box.y) * r, Point2(box.br().x, box.br().y) * r);
  const auto [left, right] = intervals(grid.x(), bounds.low.x(), bounds.high.x());
  const auto [bottom, top] = intervals(grid.y(), bounds.low.y(), bounds.high.y());
  for (std::size_t row = bottom; row < top; ++row) {
    for (std::size_t column = left; column < right; ++column) {
      cells.insert(grid.index({static_cast<int>(row), static_cast<int>(column)}));
    }
  }
}

/// Counts the labels in single cells.
class CellLabeller {
 public:
  CellLabeller(const AGrid& grid, const MapGeometry& geometry,
               const std::vector<std::uint16_t>& pixel_labels)
      : grid_(grid), geometry_(geometry), labels_(pixel_labels), raster_(grid, geometry) {}

  /// The label that most pixels of a cell have (a tie: the lowest), 0 if none has any.
  std::uint16_t most(Cell cell) const {
    const Point2 low(grid_.x()[static_cast<std::size_t>(cell.column)],
                     grid_.y()[static_cast<std::size_t>(cell.row)]);
    const Point2 high(grid_.x()[static_cast<std::size_t>(cell.column) + 1],
                      grid_.y()[static_cast<std::size_t>(cell.row) + 1]);
    const Pose2 image_from_grid = inverse(geometry_.map_from_image) * grid_.mapFromGrid();
    const Bounds bounds = enclose(image_from_grid, low, high);
    const auto pixels = [&](double from, double to, int end) {
      return cv::Range(std::clamp(static_cast<int>(from / geometry_.resolution) - 1, 0, end),
                       std::clamp(static_cast<int>(to / geometry_.resolution) + 2, 0, end));
    };
    const cv::Range columns = pixels(bounds.low.x(), bounds.high.x(), geometry_.width);
    const cv::Range rows = pixels(bounds.low.y(), bounds.high.y(), geometry_.height);
    std::map<std::uint16_t, std::size_t> count;
    std::pair<std::uint16_t, std::size_t> run{std::uint16_t{0}, 0U};
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = columns.start; x < columns.end; ++x) {
        const Point2 p = raster_.center(x, y);
        if (p.x() < low.x() || p.y() < low.y() || p.x() >= high.x() || p.y() >= high.y()) continue;
        const std::uint16_t label = labels_[geometry_.index({x, y})];
        if (label != run.first) {
          count[run.first] += run.second;
          run = {label, 0};
        }
        ++run.second;
      }
    }
    count[run.first] += run.second;
    count.erase(0);
    std::pair<std::uint16_t, std::size_t> best{std::uint16_t{0}, 0U};
    for (const auto& [label, pixels_of_it] : count) {
      if (pixels_of_it > best.second) best = {label, pixels_of_it};
    }
    return best.first;
  }

 private:
  const AGrid& grid_;
  const MapGeometry& geometry_;
  const std::vector<std::uint16_t>& labels_;
  PixelRaster raster_;
};

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

void relabelCells(const AGrid& grid, const MapGeometry& geometry,
                  const std::vector<std::uint16_t>& pixel_labels, const std::vector<Area>& areas,
                  const std::vector<cv::Rect>& changed, std::vector<AreaId>& cells) {
  std::set<std::size_t> stale;
  for (const cv::Rect& box : changed) addCells(grid, geometry, box, stale);
  const CellLabeller labeller(grid, geometry, pixel_labels);
  for (const std::size_t cell : stale) {
    const std::uint16_t label = labeller.most(grid.cell(cell));
    cells[cell] = label == 0 ? AreaId{0} : areas[label - 1U].id;
  }
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
