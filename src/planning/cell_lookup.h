// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid::planning {

/// Which cells of the A-Grid hold pixels' centres, as row-major indices; a centre outside the grid
/// belongs to the nearest cell.
class CellLookup {
 public:
  CellLookup(const MapGeometry& geometry, const AGrid& grid);
  /// Of a path's pixels, in order; none twice in a row.
  std::vector<std::uint32_t> cellsAlong(const std::vector<Pixel>& pixels) const;

 private:
  const AGrid* grid_;
  Point2 origin_;   ///< centre of pixel (0, 0), grid frame [m]
  Point2 along_x_;  ///< to the next pixel of the row
  Point2 along_y_;  ///< to the same pixel of the next row
};

}  // namespace agrid::planning
