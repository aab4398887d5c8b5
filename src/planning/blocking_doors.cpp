// SPDX-License-Identifier: BSD-3-Clause
#include "planning/blocking_doors.h"

#include <sstream>

namespace agrid::planning {

std::string explainNoRoute(const SemanticMap& map, const RadiusLevel& level,
                           const Obstacles& obstacles, std::uint32_t start,
                           const std::vector<std::uint32_t>& goals) {
  const double radius = level.free.radiusPx() * level.free.geometry().resolution;
  std::ostringstream text;
  text << "free space does not connect start and goal for a radius of " << radius << " m";
  const char* separator = "; in the way: ";
  for (const Barrier& barrier :
       level.barriers().of(map, level, obstacles).fewestBetween(start, goals)) {
    const Door& door = map.area_map.doors[barrier.door];
    const bool closed = door.state == DoorState::kClosed;
    text << separator << (closed ? "closed " : "") << (closed && barrier.too_narrow ? "and " : "")
         << (barrier.too_narrow ? "too narrow " : "") << "door '" << door.name << "'";
    if (barrier.too_narrow) text << " (" << door.width << " m)";
    separator = ", ";
  }
  return text.str();
}

}  // namespace agrid::planning
