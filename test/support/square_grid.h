// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid::test {

/// A grid of square cells that covers a map, along its pixels.
inline AGrid squareGrid(const MapGeometry& geometry, double side) {
  std::vector<double> x{0};
  std::vector<double> y{0};
  while (x.back() < geometry.width * geometry.resolution) x.push_back(x.back() + side);
  while (y.back() < geometry.height * geometry.resolution) y.push_back(y.back() + side);
  return {geometry.map_from_image, x, y};
}

}  // namespace agrid::test
