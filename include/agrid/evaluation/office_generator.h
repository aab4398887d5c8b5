// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// A drawn office with what is true about it.
struct Office {
  OccupancyGrid grid;                   ///< values 0 free, 100 occupied, -1 unknown
  std::vector<std::uint16_t> rooms;     ///< row-major like the grid: 0 = none, k = room k; free
                                        ///< floor and furniture, not the floor within doorways
  std::vector<Segment> doors_map;       ///< doors that stand open, jamb to jamb [m]; one room lies
                                        ///< on either side
  std::vector<Segment> shut_doors_map;  ///< doors that were shut when the map was made [m]
};

/// What to draw.
struct OfficeParams {
  int size = 600;            ///< pixels a side, 100..20000
  std::uint32_t seed = 1;    ///< the same seed draws the same office on every machine
  double resolution = 0.05;  ///< [m], 0.02..0.2; the side is 5..1000 m long
  bool furniture = true;     ///< tables, chairs, cabinets, door leaves
  bool noise = true;  ///< ragged walls, stray points, unseen corners, rays through windows, as from
                      ///< a laser
};

/// Draws rooms, corridors, doors and furniture. Every room can be reached through open doors.
/// Takes time and memory in proportion to the pixels.
/// @throws std::invalid_argument if a parameter is out of range
Office generateOffice(const OfficeParams& params);

}  // namespace agrid
