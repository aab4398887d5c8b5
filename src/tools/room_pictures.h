// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid::tools {

/// Pictures of true rooms, of the size of the map's image. Each returns row-major labels like the
/// map: 0 = no room, k = room k, and throws FileError if the picture cannot be read, has another
/// size or more than 65535 rooms.

/// A 16- or 8-bit grey picture: 0 = no room, k = room k.
std::vector<std::uint16_t> readNumberedRooms(const std::string& path, const MapGeometry& geometry);

/// An 8-bit grey picture: k = room k + 1, 255 = no room.
std::vector<std::uint16_t> readLocations(const std::string& path, const MapGeometry& geometry);

/// A picture painted by a person. If more than a twentieth of it is coloured (channels that differ
/// by more than 40), each colour is a room; otherwise each connected white part (grey above 250,
/// 8 neighbours) is one.
std::vector<std::uint16_t> readPaintedRooms(const std::string& path, const MapGeometry& geometry);

/// A picture of areas of either kind: room numbers if it has 16 bits, or is grey without white
/// (above 250); else painted.
std::vector<std::uint16_t> readAreaPicture(const std::string& path, const MapGeometry& geometry);

}  // namespace agrid::tools
