// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cell_rows.h"

#include <algorithm>

namespace agrid::planning {
namespace {

/// The interval that holds a value; of values outside, the first or the last. Begins at `hint`,
/// from which the answer is usually not far.
int intervalNear(const std::vector<double>& edges, double value, int hint) {
  const int last = static_cast<int>(edges.size()) - 2;
  while (hint < last && value >= edges[static_cast<std::size_t>(hint) + 1]) ++hint;
  while (hint > 0 && value < edges[static_cast<std::size_t>(hint)]) --hint;
  return hint;
}

}  // namespace

CellRows::CellRows(const MapGeometry& geometry, const AGrid& grid) : grid_(&grid) {
  const Pose2 grid_from_image = inverse(grid.mapFromGrid()) * geometry.map_from_image;
  const double r = geometry.resolution;
  origin_ = grid_from_image * Point2(r / 2, r / 2);
  along_x_ = grid_from_image * Point2(r, 0) - grid_from_image.position;
  along_y_ = grid_from_image * Point2(0, r) - grid_from_image.position;
}

void CellRows::cellsOfRow(int y, std::vector<std::uint32_t>& cells) const {
  int row = 0;
  int column = 0;
  for (std::size_t x = 0; x < cells.size(); ++x) {
    const Point2 p = origin_ + static_cast<double>(x) * along_x_ + y * along_y_;
    row = intervalNear(grid_->y(), p.y(), row);
    column = intervalNear(grid_->x(), p.x(), column);
    cells[x] = static_cast<std::uint32_t>(grid_->index({row, column}));
  }
}

std::uint32_t CellRows::cellOf(Pixel p) const {
  const Point2 q = origin_ + p.x * along_x_ + p.y * along_y_;
  const auto interval = [](const std::vector<double>& edges, double value) {
    const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
    return static_cast<int>(above - edges.begin()) - 1;
  };
  return static_cast<std::uint32_t>(
      grid_->index({interval(grid_->y(), q.y()), interval(grid_->x(), q.x())}));
}

}  // namespace agrid::planning
