// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// A drawn office with what is true about it.
struct Office {
  OccupancyGrid grid;
  std::vector<std::uint16_t> rooms;  ///< row-major like the grid: 0 = none, k = room k
  std::vector<Segment> doors_map;    ///< jamb to jamb [m]
};

struct OfficeParams {
  int size = 600;            ///< pixels a side
  std::uint32_t seed = 1;    ///< the same seed draws the same office
  double resolution = 0.05;  ///< [m]
  bool furniture = true;
  bool noise = true;  ///< ragged walls, stray points, rays through windows, as from a laser
};

/// Draws rooms, corridors, doors and furniture.
/// @throws std::invalid_argument if a parameter is out of range
Office generateOffice(const OfficeParams& params);

}  // namespace agrid
