// SPDX-License-Identifier: BSD-3-Clause
#include "areas/room_borders.h"

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

/// Turns rows upside down.
class Flip {
 public:
  explicit Flip(const MapGeometry& geometry) : geometry_(geometry) {}
  std::size_t operator()(std::size_t index) const {
    const Pixel p = geometry_.pixel(index);
    return geometry_.index({p.x, geometry_.height - 1 - p.y});
  }
  std::vector<std::uint32_t> operator()(const std::vector<std::uint32_t>& labels) const {
    std::vector<std::uint32_t> flipped(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) flipped[(*this)(i)] = labels[i];
    return flipped;
  }
  BorderPoint operator()(BorderPoint point) const {
    const bool beside = point.other == point.pixel + 1;
    point.pixel = (*this)(point.pixel);
    point.other = (*this)(point.other);
    if (!beside) std::swap(point.pixel, point.other);
    return point;
  }

 private:
  const MapGeometry& geometry_;
};

}  // namespace

std::vector<Stretch> findRoomBorders(const OccupancyMap& map,
                                     const std::vector<std::uint16_t>& rooms, double min_length) {
  const MapGeometry& geometry = map.geometry();
  // A border point counts as the left or upper one of its pixels, as in a picture: where a border
  // is torn, it depends on that whether its parts are one.
  const Flip flip(geometry);
  const auto points = findBorderPoints(flip(growRooms(map, rooms)), geometry);
  std::vector<Stretch> borders;
  for (Stretch& stretch : splitIntoStretches(points, geometry)) {
    if (extentOf(stretch, geometry) < min_length / geometry.resolution) continue;
    for (BorderPoint& point : stretch) point = flip(point);
    borders.push_back(std::move(stretch));
  }
  return borders;
}

}  // namespace agrid
