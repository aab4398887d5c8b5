// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid {

/// The same place as another map might show it: what areas and doors are should hardly change.
/// Each pixel of the new map is the pixel of the old one that holds its centre (nearest neighbour),
/// unknown where there is none. Points of the map frame stay where they are: the new pose of the
/// image frame says how the pixels moved.

/// The map's pixels turned counter-clockwise about its centre, on a canvas that holds all of them.
OccupancyMap turned(const OccupancyMap& map, double degrees);

/// The map in pixels of another size; the lower left corner stays.
/// @param resolution  [m], see OccupancyMap
/// @throws MapError if the resolution is not allowed or the map gets too large
OccupancyMap resampled(const OccupancyMap& map, double resolution);

/// The map with 30 % of the free pixels that touch one that is not free (8 neighbours) and 0.1 % of
/// the other free ones made occupied. The same seed makes the same map on every machine.
OccupancyMap noisy(const OccupancyMap& map, std::uint32_t seed);

/// Whether one of the 8 neighbours of a pixel is on the map and not free: what noise wears first.
bool touchesObstacle(const OccupancyMap& map, Pixel pixel);

/// Brings labels from one map of a place to the pixels of another: each gets the label of the pixel
/// that holds its centre, 0 outside.
/// @param labels  row-major like `from`
/// @throws std::invalid_argument if their number is not that of the pixels of `from`
std::vector<std::uint16_t> labelsOn(const MapGeometry& to, const MapGeometry& from,
                                    const std::vector<std::uint16_t>& labels);

}  // namespace agrid
