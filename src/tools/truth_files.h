// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid::tools {

/// Reads the true rooms of a map; the file's name tells its format (doc/tool.md): polygons in
/// `*.yaml`, of which only free pixels count, room numbers in `rooms.png`, numbers from 0 in
/// `locations.png`, else a picture whose rooms are white or coloured.
/// @return row-major like the map: 0 = no room, k = room k
/// @throws FileError if the file cannot be read, is not of the map's size or has too many rooms
std::vector<std::uint16_t> readTrueRooms(const std::string& path, const OccupancyMap& map);

/// True doors.
struct TrueDoors {
  std::vector<Segment> jambs_map;  ///< [m]
  bool complete = false;           ///< whether a door that is not among them is wrong
};

/// Reads the true doors of a map: `*.csv` has all of them in image pixels, `*.yaml` some.
/// @throws FileError
TrueDoors readTrueDoors(const std::string& path, const MapGeometry& geometry);

}  // namespace agrid::tools
