// SPDX-License-Identifier: BSD-3-Clause
#include "planning/obstacles.h"

#include <algorithm>

#include "map/squared_distance.h"
#include "planning/door_pixels.h"

namespace agrid::planning {
namespace {

/// Marks the eight neighbours of every marked pixel: the distance to the nearest mark is then the
/// distance between the pixels' squares, max(|dx| - 1, 0)^2 + max(|dy| - 1, 0)^2.
void widenByOnePixel(const MapGeometry& geometry, std::vector<std::uint8_t>& marked) {
  const auto width = static_cast<std::size_t>(geometry.width);
  const auto height = static_cast<std::size_t>(geometry.height);
  std::vector<std::uint8_t> along(marked);
  for (std::size_t i = 0; i < marked.size(); ++i) {
    const std::size_t x = i % width;
    if (x > 0) along[i] |= marked[i - 1];
    if (x + 1 < width) along[i] |= marked[i + 1];
  }
  marked = along;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (i >= width) marked[i] |= along[i - width];
    if (i + width < width * height) marked[i] |= along[i + width];
  }
}

}  // namespace

Obstacles::Obstacles(const SemanticMap& map, bool allow_unknown, Clearance clearance)
    : map_(&map.map()), allow_unknown_(allow_unknown), clearance_(clearance) {
  for (const Door& door : map.area_map.doors) {
    if (door.state != DoorState::kClosed) continue;
    std::vector<std::size_t> pixels = pixelsOf(door.jambs_map);
    door_pixels_.insert(door_pixels_.end(), pixels.begin(), pixels.end());
    std::sort(pixels.begin(), pixels.end());
    if (!pixels.empty()) closed_doors_.push_back(std::move(pixels));
  }
  std::sort(closed_doors_.begin(), closed_doors_.end());
  closed_doors_.erase(std::unique(closed_doors_.begin(), closed_doors_.end()), closed_doors_.end());
  std::sort(door_pixels_.begin(), door_pixels_.end());
  door_pixels_.erase(std::unique(door_pixels_.begin(), door_pixels_.end()), door_pixels_.end());
}

bool Obstacles::blockedInMap(std::size_t pixel_index) const {
  const Occupancy occupancy = map_->pixels()[pixel_index];
  return occupancy == Occupancy::kOccupied || (occupancy == Occupancy::kUnknown && !allow_unknown_);
}

bool Obstacles::at(std::size_t pixel_index) const {
  return blockedInMap(pixel_index) ||
         std::binary_search(door_pixels_.begin(), door_pixels_.end(), pixel_index);
}

std::vector<std::size_t> Obstacles::pixelsOf(const Segment& jambs_map) const {
  return doorPixels(map_->geometry(), jambs_map,
                    [this](std::size_t index) { return !blockedInMap(index); });
}

std::vector<std::uint8_t> Obstacles::openMask() const {
  std::vector<std::uint8_t> mask(map_->pixels().size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = blockedInMap(i) ? 1 : 0;
  return mask;
}

std::vector<std::uint8_t> Obstacles::mask() const {
  std::vector<std::uint8_t> mask = openMask();
  for (const std::size_t i : door_pixels_) mask[i] = 1;
  return mask;
}

std::vector<std::int32_t> distancesToMarked(const MapGeometry& geometry,
                                            std::vector<std::uint8_t> marked, Clearance clearance,
                                            const StopCheck& stop) {
  if (clearance == Clearance::kStrict) widenByOnePixel(geometry, marked);
  return squaredDistances(geometry, marked, [&stop] { stop.check(); });
}

std::vector<std::int32_t> obstacleDistances(const MapGeometry& geometry, const Obstacles& obstacles,
                                            Clearance clearance, const StopCheck& stop) {
  return distancesToMarked(geometry, obstacles.mask(), clearance, stop);
}

}  // namespace agrid::planning
