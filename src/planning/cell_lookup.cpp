// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cell_lookup.h"

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

CellLookup::CellLookup(const MapGeometry& geometry, const AGrid& grid) : grid_(&grid) {
  const Pose2 grid_from_image = inverse(grid.mapFromGrid()) * geometry.map_from_image;
  const double r = geometry.resolution;
  origin_ = grid_from_image * Point2(r / 2, r / 2);
  along_x_ = grid_from_image * Point2(r, 0) - grid_from_image.position;
  along_y_ = grid_from_image * Point2(0, r) - grid_from_image.position;
}

std::vector<std::uint32_t> CellLookup::cellsAlong(const std::vector<Pixel>& pixels) const {
  std::vector<std::uint32_t> cells;
  Cell cell;
  for (const Pixel p : pixels) {
    const Point2 q = origin_ + p.x * along_x_ + p.y * along_y_;
    cell.row = intervalNear(grid_->y(), q.y(), cell.row);
    cell.column = intervalNear(grid_->x(), q.x(), cell.column);
    const auto index = static_cast<std::uint32_t>(grid_->index(cell));
    if (cells.empty() || cells.back() != index) cells.push_back(index);
  }
  return cells;
}

}  // namespace agrid::planning
