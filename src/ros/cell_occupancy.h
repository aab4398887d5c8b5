// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/grid/a_grid.h"
#include "agrid/map/occupancy_map.h"

namespace agrid_map_ros {

/// The share of occupied pixels of each cell in percent, rounded to the nearest; -1 where no pixel
/// of the cell is known. A pixel belongs to the cell that holds its centre.
std::vector<std::int8_t> cellOccupancy(const agrid::OccupancyMap& map, const agrid::AGrid& grid);

}  // namespace agrid_map_ros
