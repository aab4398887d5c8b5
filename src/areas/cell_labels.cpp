// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_labels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "areas/cell_shares.h"

namespace agrid {
namespace {

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

}  // namespace

std::vector<std::size_t> cellsOf(const AGrid& grid, const MapGeometry& geometry,
                                 const cv::Rect& box) {
  std::vector<std::size_t> cells;
  const double r = geometry.resolution;
  const Bounds bounds = enclose(inverse(grid.mapFromGrid()) * geometry.map_from_image,
                                Point2(box.x, box.y) * r, Point2(box.br().x, box.br().y) * r);
  const auto [left, right] = intervals(grid.x(), bounds.low.x(), bounds.high.x());
  const auto [bottom, top] = intervals(grid.y(), bounds.low.y(), bounds.high.y());
  for (std::size_t row = bottom; row < top; ++row) {
    for (std::size_t column = left; column < right; ++column) {
      cells.push_back(grid.index({static_cast<int>(row), static_cast<int>(column)}));
    }
  }
  return cells;
}

std::uint16_t CellLabeller::most(Cell cell) const {
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

std::vector<AreaId> labelCells(const AGrid& grid, const MapGeometry& geometry,
                               const PixelLabels& labels, const std::vector<Area>& areas) {
  const CellShares shares(grid, geometry, labels, areas.size());
  std::vector<AreaId> cells(grid.cellCount(), AreaId{0});
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    CellShare most;
    for (const CellShare* share = shares.begin(cell); share != shares.end(cell); ++share) {
      if (share->pixels > most.pixels) most = *share;
    }
    if (most.label != 0) cells[cell] = areas[most.label - 1U].id;
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
