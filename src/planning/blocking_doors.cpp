// SPDX-License-Identifier: BSD-3-Clause
#include "planning/blocking_doors.h"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <sstream>
#include <vector>

namespace agrid::planning {
namespace {

/// How far beside a door its rooms' free space is looked for [m].
constexpr double kReach = 3;

/// The component that one reaches first when leaving a door to one side.
std::optional<std::uint32_t> componentBeside(const RadiusLevel& level, const Door& door,
                                             double side) {
  const MapGeometry& geometry = level.free.geometry();
  const Point2 along = door.jambs_map.b - door.jambs_map.a;
  if (!(along.norm() > 0)) return std::nullopt;
  const Point2 out = side * Point2(-along.y(), along.x()) / along.norm();
  for (double d = geometry.resolution; d <= kReach; d += geometry.resolution / 2) {
    const auto pixel = geometry.pixelAt(door.jambs_map.midpoint() + d * out);
    if (!pixel) return std::nullopt;
    const std::uint32_t region = level.roadmap.regions().nodeAt(geometry.index(*pixel));
    if (region != kNoNode) return level.roadmap.regions().componentOf(region);
  }
  return std::nullopt;
}

struct Link {
  std::size_t door;
  std::uint32_t to;
};

std::map<std::uint32_t, std::vector<Link>> linksThroughDoors(const SemanticMap& map,
                                                             const RadiusLevel& level) {
  std::map<std::uint32_t, std::vector<Link>> links;
  for (std::size_t d = 0; d < map.area_map.doors.size(); ++d) {
    const auto a = componentBeside(level, map.area_map.doors[d], -1);
    const auto b = componentBeside(level, map.area_map.doors[d], 1);
    if (!a || !b || *a == *b) continue;
    links[*a].push_back({d, *b});
    links[*b].push_back({d, *a});
  }
  return links;
}

/// Breadth first: the doors on a way with the fewest doors, from the start on.
std::vector<std::size_t> fewestDoors(const std::map<std::uint32_t, std::vector<Link>>& links,
                                     std::uint32_t start, std::uint32_t goal) {
  std::map<std::uint32_t, Link> came_by;
  std::queue<std::uint32_t> open;
  open.push(start);
  while (!open.empty() && came_by.count(goal) == 0) {
    const std::uint32_t here = open.front();
    open.pop();
    const auto found = links.find(here);
    if (found == links.end()) continue;
    for (const Link& link : found->second) {
      if (link.to == start || !came_by.emplace(link.to, Link{link.door, here}).second) continue;
      open.push(link.to);
    }
  }
  std::vector<std::size_t> doors;
  if (came_by.count(goal) == 0) return doors;
  for (std::uint32_t c = goal; c != start; c = came_by.at(c).to) {
    doors.push_back(came_by.at(c).door);
  }
  std::reverse(doors.begin(), doors.end());
  return doors;
}

}  // namespace

std::string explainNoRoute(const SemanticMap& map, const RadiusLevel& level,
                           std::uint32_t start_component, std::uint32_t goal_component) {
  const double radius = level.free.radiusPx() * level.free.geometry().resolution;
  std::ostringstream text;
  text << "free space does not connect start and goal for a radius of " << radius << " m";
  const auto doors = fewestDoors(linksThroughDoors(map, level), start_component, goal_component);
  const char* separator = "; in the way: ";
  for (const std::size_t d : doors) {
    const Door& door = map.area_map.doors[d];
    text << separator;
    separator = ", ";
    if (door.state == DoorState::kClosed) {
      text << "closed door '" << door.name << "'";
    } else {
      text << "too narrow door '" << door.name << "' (" << door.width << " m)";
    }
  }
  return text.str();
}

}  // namespace agrid::planning
