// SPDX-License-Identifier: BSD-3-Clause
#include "planning/door_surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <set>

#include "planning/radius_level.h"

namespace agrid::planning {
namespace {

/// How far from a door that is too narrow its rooms' free space is looked for [m].
constexpr double kReach = 3;

/// Unites the sets that have an element in common.
std::vector<std::vector<std::uint32_t>> united(const std::vector<std::set<std::uint32_t>>& sets) {
  std::vector<std::set<std::uint32_t>> groups;
  for (std::set<std::uint32_t> joined : sets) {
    for (std::size_t i = 0; i < groups.size();) {
      const bool meets = std::any_of(groups[i].begin(), groups[i].end(),
                                     [&](std::uint32_t c) { return joined.count(c) != 0; });
      if (meets) joined.insert(groups[i].begin(), groups[i].end());
      meets ? static_cast<void>(groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(i)))
            : static_cast<void>(++i);
    }
    groups.push_back(std::move(joined));
  }
  std::vector<std::vector<std::uint32_t>> lists;
  for (const auto& group : groups) {
    if (group.size() > 1) lists.emplace_back(group.begin(), group.end());
  }
  return lists;
}

/// On which side of a line a point lies: 0 or 1.
std::size_t sideOf(const Segment& line, const Point2& p) {
  const Point2 along = line.b - line.a;
  const Point2 to = p - line.a;
  return along.x() * to.y() - along.y() * to.x() > 0 ? 1 : 0;
}

}  // namespace

DoorSurroundings::DoorSurroundings(const std::vector<Door>& doors, const RadiusLevel& level,
                                   const Obstacles& obstacles)
    : doors_(doors), level_(level), obstacles_(obstacles) {
  for (std::size_t door = 0; door < doors.size(); ++door) {
    if (doors[door].state != DoorState::kClosed) continue;
    for (const std::size_t i : obstacles.pixelsOf(doors[door].jambs_map)) {
      shut_.emplace_back(i, door);
    }
  }
  std::sort(shut_.begin(), shut_.end());
}

bool DoorSurroundings::isShutByAnother(std::size_t pixel_index, std::size_t door) const {
  auto shut = std::lower_bound(shut_.begin(), shut_.end(), std::pair(pixel_index, std::size_t{0}));
  for (; shut != shut_.end() && shut->first == pixel_index; ++shut) {
    if (shut->second != door) return true;
  }
  return false;
}

std::uint32_t DoorSurroundings::componentAt(Pixel p) const {
  const PortalGraph& regions = level_.roadmap.regions();
  const std::uint32_t region = regions.nodeAt(level_.free.geometry().index(p));
  return region == kNoNode ? kNoNode : regions.componentOf(region);
}

/// The pixels of a box that are free only without the door.
std::vector<bool> DoorSurroundings::freedBy(std::size_t door, const PixelBox& box) const {
  const FreeSpace& free = level_.free;
  const MapGeometry& geometry = free.geometry();
  // What is not free because of a pixel is no farther from it than this.
  const PixelBox around = clippedTo(geometry, widened(box, static_cast<int>(free.radiusPx()) + 3));
  MapGeometry local = geometry;
  local.width = static_cast<int>(around.columns());
  local.height = static_cast<int>(around.rows());
  std::vector<std::uint8_t> marked;
  forEachPixel(around, [&](Pixel p) {
    const std::size_t i = geometry.index(p);
    marked.push_back(obstacles_.blockedInMap(i) || isShutByAnother(i, door) ? 1 : 0);
  });
  const auto distances = distancesToMarked(local, std::move(marked), obstacles_.clearance());
  std::vector<bool> freed;
  forEachPixel(box, [&](Pixel p) {
    freed.push_back(!free.isFree(p) && free.isInside(p) &&
                    free.isFarEnough(distances[indexIn(around, p)]));
  });
  return freed;
}

std::vector<std::vector<std::uint32_t>> DoorSurroundings::joinedWhenOpen(std::size_t door) const {
  const MapGeometry& geometry = level_.free.geometry();
  PixelBox box;
  if (doors_[door].state == DoorState::kClosed) {
    for (const std::size_t i : obstacles_.pixelsOf(doors_[door].jambs_map)) {
      box.add(geometry.pixel(i));
    }
  }
  if (box.high.x < 0) return {};
  box = clippedTo(geometry, widened(box, static_cast<int>(level_.free.radiusPx()) + 3));
  std::vector<bool> freed = freedBy(door, box);
  std::vector<std::set<std::uint32_t>> joined;
  forEachPixel(box, [&](Pixel first) {
    if (!freed[indexIn(box, first)]) return;
    joined.emplace_back();
    std::vector<Pixel> open{first};
    freed[indexIn(box, first)] = false;
    while (!open.empty()) {
      const Pixel p = open.back();
      open.pop_back();
      for (const Pixel q : neighbours(p)) {
        if (!geometry.contains(q)) continue;
        if (componentAt(q) != kNoNode) joined.back().insert(componentAt(q));
        if (!holds(box, q) || !freed[indexIn(box, q)]) continue;
        freed[indexIn(box, q)] = false;
        open.push_back(q);
      }
    }
  });
  return united(joined);
}

std::vector<std::uint32_t> DoorSurroundings::joinedWhenWider(std::size_t door) const {
  const MapGeometry& geometry = level_.free.geometry();
  const Segment& jambs = doors_[door].jambs_map;
  const double reach = kReach / geometry.resolution;
  std::map<std::size_t, int> steps;  // from the jambs, of the pixels walked over
  std::queue<Pixel> open;
  const auto walkTo = [&](Pixel p, int step) {
    const std::size_t i = geometry.index(p);
    if (obstacles_.blockedInMap(i) || isShutByAnother(i, door)) return;
    if (steps.emplace(i, step).second) open.push(p);
  };
  for (const std::size_t i : obstacles_.pixelsOf(jambs)) {
    if (componentAt(geometry.pixel(i)) != kNoNode) return {};
    walkTo(geometry.pixel(i), 0);
  }
  std::array<int, 2> last{{static_cast<int>(reach), static_cast<int>(reach)}};
  std::array<std::set<std::uint32_t>, 2> met;
  for (; !open.empty(); open.pop()) {
    const Pixel p = open.front();
    const int step = steps.at(geometry.index(p));
    if (step > std::max(last[0], last[1])) break;
    const std::size_t side = sideOf(jambs, geometry.center(p));
    const std::uint32_t component = componentAt(p);
    if (component != kNoNode && step <= last[side]) {
      // One side of a door that is wide enough on the whole has one component near by.
      last[side] = std::min(last[side], step + static_cast<int>(level_.free.radiusPx()));
      met[side].insert(component);
    }
    if (component != kNoNode) continue;
    for (const Pixel q : neighbours(p)) {
      if (geometry.contains(q)) walkTo(q, step + 1);
    }
  }
  if (met[0].empty() || met[1].empty()) return {};
  met[0].insert(met[1].begin(), met[1].end());
  return {met[0].begin(), met[0].end()};
}

}  // namespace agrid::planning
