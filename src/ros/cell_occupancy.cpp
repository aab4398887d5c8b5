// SPDX-License-Identifier: BSD-3-Clause
#include "ros/cell_occupancy.h"

#include <cstddef>
#include <optional>

namespace agrid_map_ros {
namespace {

/// Finds the cells of points that mostly lie near each other.
class CellCursor {
 public:
  explicit CellCursor(const agrid::AGrid& grid) : grid_(grid) {}

  std::optional<agrid::Cell> at(const agrid::Point2& point_grid) {
    if (!cell_ || !holds(*cell_, point_grid)) cell_ = grid_.cellAtGridPoint(point_grid);
    return cell_;
  }

 private:
  bool holds(agrid::Cell cell, const agrid::Point2& point) const {
    const auto column = static_cast<std::size_t>(cell.column);
    const auto row = static_cast<std::size_t>(cell.row);
    return point.x() >= grid_.x()[column] && point.x() < grid_.x()[column + 1] &&
           point.y() >= grid_.y()[row] && point.y() < grid_.y()[row + 1];
  }

  const agrid::AGrid& grid_;
  std::optional<agrid::Cell> cell_;
};

struct Counts {
  std::uint32_t pixels = 0;
  std::uint32_t known = 0;
  std::uint32_t occupied = 0;
};

}  // namespace

std::vector<std::int8_t> cellOccupancy(const agrid::OccupancyMap& map, const agrid::AGrid& grid) {
  const agrid::MapGeometry& geometry = map.geometry();
  const agrid::Pose2 grid_from_image = inverse(grid.mapFromGrid()) * geometry.map_from_image;
  const agrid::Pose2 turn{agrid::Point2::Zero(), grid_from_image.yaw};
  const agrid::Point2 step = turn * agrid::Point2(geometry.resolution, 0);
  std::vector<Counts> counts(grid.cellCount());
  CellCursor cursor(grid);
  for (int y = 0; y < geometry.height; ++y) {
    const agrid::Point2 row_start =
        grid_from_image * agrid::Point2(0.5 * geometry.resolution, (y + 0.5) * geometry.resolution);
    for (int x = 0; x < geometry.width; ++x) {
      const auto cell = cursor.at(row_start + x * step);
      if (!cell) continue;
      Counts& count = counts[grid.index(*cell)];
      const agrid::Occupancy pixel = map.at({x, y});
      ++count.pixels;
      count.known += pixel != agrid::Occupancy::kUnknown;
      count.occupied += pixel == agrid::Occupancy::kOccupied;
    }
  }
  std::vector<std::int8_t> shares;
  shares.reserve(counts.size());
  for (const Counts& c : counts) {
    const std::uint64_t rounded =
        c.known == 0 ? 0
                     : (std::uint64_t{200} * c.occupied + c.pixels) / (2 * std::uint64_t{c.pixels});
    shares.push_back(c.known == 0 ? std::int8_t{-1} : static_cast<std::int8_t>(rounded));
  }
  return shares;
}

}  // namespace agrid_map_ros
