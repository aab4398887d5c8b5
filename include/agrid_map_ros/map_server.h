// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include <nav_msgs/OccupancyGrid.h>

#include "agrid/map/map_io.h"

namespace agrid_map_ros {

/// The message that map_server publishes of a map, but for its times, which stay zero.
nav_msgs::OccupancyGrid mapServerMessage(agrid::LoadedMap map, const std::string& frame_id);

/// The path that a map's address means: a path as it is, or file://[localhost]/PATH with %XX
/// decoded.
/// @throws agrid::FileError (kPath) for another scheme, another host or a broken %XX
std::string pathOfUrl(const std::string& url);

/// The result of nav_msgs/LoadMap that tells of a file's failure.
std::uint8_t loadMapResult(agrid::FileErrorCode code);

}  // namespace agrid_map_ros
