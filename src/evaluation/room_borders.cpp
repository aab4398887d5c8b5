// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/room_borders.h"

#include <algorithm>
#include <utility>

#include "tags/basins.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

/// Extends the rooms by one pixel a round; a pixel that several reach goes to the highest number.
std::vector<std::uint32_t> growRooms(const OccupancyMap& map,
                                     const std::vector<std::uint16_t>& rooms) {
  const MapGeometry& geometry = map.geometry();
  std::vector<std::uint32_t> grown(rooms.begin(), rooms.end());
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i] != 0) front.push_back(i);
  }
  while (!front.empty()) {
    std::vector<std::pair<std::size_t, std::uint32_t>> reached;
    for (const std::size_t i : front) {
      for (const Pixel step : kNeighbours) {
        const Pixel q = geometry.pixel(i) + step;
        if (!geometry.contains(q) || !map.isFree(q) || grown[geometry.index(q)] != 0) continue;
        reached.emplace_back(geometry.index(q), grown[i]);
      }
    }
    front.clear();
    for (const auto& [i, room] : reached) {
      if (grown[i] == 0) front.push_back(i);
      grown[i] = std::max(grown[i], room);
    }
  }
  std::replace(grown.begin(), grown.end(), std::uint32_t{0}, Basins::kNone);
  return grown;
}

}  // namespace

std::vector<Stretch> findRoomBorders(const OccupancyMap& map,
                                     const std::vector<std::uint16_t>& rooms, double min_length) {
  const MapGeometry& geometry = map.geometry();
  const auto points = findBorderPoints(growRooms(map, rooms), geometry);
  std::vector<Stretch> borders;
  for (Stretch& stretch : splitIntoStretches(points, geometry)) {
    if (extentOf(stretch, geometry) < min_length / geometry.resolution) continue;
    borders.push_back(std::move(stretch));
  }
  return borders;
}

}  // namespace agrid
