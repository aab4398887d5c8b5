// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/a_grid.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace agrid {
namespace {

void requireIncreasing(const std::vector<double>& edges, const std::string& axis) {
  if (edges.size() < 2) {
    throw std::invalid_argument("AGrid." + axis + ": " + std::to_string(edges.size()) +
                                " edges, at least 2 are needed");
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!(edges[i - 1] < edges[i])) {
      throw std::invalid_argument("AGrid." + axis + "[" + std::to_string(i) +
                                  "]: edges must be strictly increasing");
    }
  }
}

std::optional<int> interval(const std::vector<double>& edges, double value) {
  if (!(value >= edges.front() && value <= edges.back())) return std::nullopt;
  const auto above = std::upper_bound(edges.begin(), edges.end(), value);
  const auto i = static_cast<int>(above - edges.begin()) - 1;
  return std::min(i, static_cast<int>(edges.size()) - 2);
}

}  // namespace

AGrid::AGrid(const Pose2& map_from_grid, std::vector<double> x, std::vector<double> y)
    : map_from_grid_(map_from_grid), x_(std::move(x)), y_(std::move(y)) {
  requireIncreasing(x_, "x");
  requireIncreasing(y_, "y");
}

std::optional<Cell> AGrid::cellAtGridPoint(const Point2& point_grid) const {
  const auto column = interval(x_, point_grid.x());
  const auto row = interval(y_, point_grid.y());
  if (!column || !row) return std::nullopt;
  return Cell{*row, *column};
}

std::optional<Cell> AGrid::cellAt(const Point2& point_map) const {
  return cellAtGridPoint(inverse(map_from_grid_) * point_map);
}

Point2 AGrid::cellCenter(Cell c) const {
  const auto column = static_cast<std::size_t>(c.column);
  const auto row = static_cast<std::size_t>(c.row);
  return map_from_grid_ * Point2((x_[column] + x_[column + 1]) / 2, (y_[row] + y_[row + 1]) / 2);
}

}  // namespace agrid
