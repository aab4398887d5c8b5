// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "tags/borders.h"

namespace agrid {

/// The borders between rooms, which are grown through the free pixels of the map until they meet:
/// connected stretches of at least `min_length` [m].
/// @param rooms  row-major like the map: 0 = no room, k = room k
std::vector<Stretch> findRoomBorders(const OccupancyMap& map,
                                     const std::vector<std::uint16_t>& rooms, double min_length);

}  // namespace agrid
