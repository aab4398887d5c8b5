// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "agrid/geometry/pose2.h"

namespace agrid {

/// Row and column of an A-Grid cell; row 0 has the smallest y of the grid frame.
struct Cell {
  int row = 0;
  int column = 0;
};

inline bool operator==(Cell a, Cell b) { return a.row == b.row && a.column == b.column; }
inline bool operator!=(Cell a, Cell b) { return !(a == b); }

/// The A-Grid (paper, 3.1): a non-uniform grid over the metric map that reads as a matrix.
/// Immutable. Cell (r, c) covers [x[c], x[c+1]) x [y[r], y[r+1]) of the grid frame; the last row
/// and column also hold their outer edge.
class AGrid {
 public:
  /// @param map_from_grid  pose of the grid frame in the map frame
  /// @param x, y  edge coordinates in the grid frame [m]
  /// @throws std::invalid_argument if an axis has fewer than two edges or is not strictly
  /// increasing
  AGrid(const Pose2& map_from_grid, std::vector<double> x, std::vector<double> y);

  const Pose2& mapFromGrid() const { return map_from_grid_; }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  int rows() const { return static_cast<int>(y_.size()) - 1; }
  int columns() const { return static_cast<int>(x_.size()) - 1; }
  std::size_t cellCount() const {
    return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(columns());
  }

  bool contains(Cell c) const {
    return c.row >= 0 && c.column >= 0 && c.row < rows() && c.column < columns();
  }
  /// Row-major index from (x[0], y[0]), as in messages and files.
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(c.column);
  }
  Cell cell(std::size_t index) const {
    const auto n = static_cast<std::size_t>(columns());
    return {static_cast<int>(index / n), static_cast<int>(index % n)};
  }

  /// The cell that holds a point of the map frame [m], in O(log n); none outside the grid.
  std::optional<Cell> cellAt(const Point2& point_map) const;
  /// The same for a point of the grid frame [m].
  std::optional<Cell> cellAtGridPoint(const Point2& point_grid) const;
  /// Centre of a cell, map frame [m].
  Point2 cellCenter(Cell c) const;

 private:
  Pose2 map_from_grid_;
  std::vector<double> x_;
  std::vector<double> y_;
};

}  // namespace agrid
