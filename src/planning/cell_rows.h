// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid::planning {

/// Which cell of the A-Grid holds a pixel's centre, as row-major indices; a centre outside the grid
/// belongs to the nearest cell.
class CellRows {
 public:
  CellRows(const MapGeometry& geometry, const AGrid& grid);
  /// @param cells  as many as the map has columns
  void cellsOfRow(int y, std::vector<std::uint32_t>& cells) const;
  std::uint32_t cellOf(Pixel p) const;

 private:
  const AGrid* grid_;
  Point2 origin_;   ///< centre of pixel (0, 0), grid frame [m]
  Point2 along_x_;  ///< to the next pixel of the row
  Point2 along_y_;  ///< to the same pixel of the next row
};

}  // namespace agrid::planning
