// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

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

}  // namespace agrid
