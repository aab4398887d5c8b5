// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/object_cells.h"

#include <algorithm>
#include <cmath>

namespace agrid {
namespace {

/// A range of intervals between edges, empty if first > last.
struct Range {
  int first = 0;
  int last = -1;
};

/// The half-open intervals that hold something of [low, high]; the last one has its end, too.
Range intervalsOf(const std::vector<double>& edges, double low, double high) {
  if (!(high >= edges.front() && low <= edges.back())) return {};
  if (low < high && (high == edges.front() || low == edges.back())) return {};
  const int count = static_cast<int>(edges.size()) - 1;
  const auto above = std::upper_bound(edges.begin(), edges.end(), low);
  // of more than a point nothing but its end would lie in the interval that begins there
  const auto beyond = low < high ? std::lower_bound(edges.begin(), edges.end(), high)
                                 : std::upper_bound(edges.begin(), edges.end(), high);
  const int first = static_cast<int>(above - edges.begin()) - 1;
  const int last = static_cast<int>(beyond - edges.begin()) - 1;
  return {std::clamp(first, 0, count - 1), std::clamp(last, 0, count - 1)};
}

/// An object's box in the grid frame.
struct Box {
  Box(const AGrid& grid, const ObjectTag& object)
      : pose(inverse(grid.mapFromGrid()) * object.pose_map), half(object.size.cwiseAbs() / 2) {
    const double c = std::abs(std::cos(pose.yaw));
    const double s = std::abs(std::sin(pose.yaw));
    reach = {c * half.x() + s * half.y(), s * half.x() + c * half.y()};
    finite = pose.position.allFinite() && std::isfinite(pose.yaw) && half.allFinite();
  }

  Range columns(const AGrid& grid) const { return along(grid.x(), 0); }
  Range rows(const AGrid& grid) const { return along(grid.y(), 1); }

  /// Whether neither of the box's own axes parts it from a cell (the grid's axes are left out).
  bool meets(const AGrid& grid, Cell cell) const {
    if (half.isZero()) return true;
    const auto column = static_cast<std::size_t>(cell.column);
    const auto row = static_cast<std::size_t>(cell.row);
    const Point2 low(grid.x()[column], grid.y()[row]);
    const Point2 high(grid.x()[column + 1], grid.y()[row + 1]);
    const Point2 extent = (high - low) / 2;
    const Point2 offset = (low + high) / 2 - pose.position;
    const double c = std::cos(pose.yaw);
    const double s = std::sin(pose.yaw);
    const auto apart = [&](double x, double y, double own) {
      const double cells = extent.x() * std::abs(x) + extent.y() * std::abs(y);
      const double gap = std::abs(offset.x() * x + offset.y() * y) - cells - own;
      // a line along a side has been given to one of both cells
      return own > 0 ? gap >= 0 : gap > 0;
    };
    return !apart(c, s, half.x()) && !apart(-s, c, half.y());
  }

  Pose2 pose;    // grid frame
  Point2 half;   // half its size along its own axes [m]
  Point2 reach;  // ... and along those of the grid
  bool finite = false;

 private:
  Range along(const std::vector<double>& edges, int axis) const {
    if (!finite) return {};
    return intervalsOf(edges, pose.position[axis] - reach[axis], pose.position[axis] + reach[axis]);
  }
};

bool holds(Range range, int value) { return range.first <= value && value <= range.last; }

}  // namespace

bool overlaps(const AGrid& grid, const ObjectTag& object, Cell cell) {
  const Box box(grid, object);
  return holds(box.columns(grid), cell.column) && holds(box.rows(grid), cell.row) &&
         box.meets(grid, cell);
}

std::vector<std::uint32_t> cellsOf(const SemanticMap& map, const ObjectTag& object) {
  const AGrid& grid = map.grid();
  const Box box(grid, object);
  const Range rows = box.rows(grid);
  const Range columns = box.columns(grid);
  std::vector<std::uint32_t> cells;
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      const Cell cell{row, column};
      if (box.meets(grid, cell)) cells.push_back(static_cast<std::uint32_t>(grid.index(cell)));
    }
  }
  return cells;
}

}  // namespace agrid
