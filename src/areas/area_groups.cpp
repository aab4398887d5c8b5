// SPDX-License-Identifier: BSD-3-Clause
#include "areas/area_groups.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "areas/door_places.h"
#include "areas/group_parts.h"
#include "tags/disjoint_sets.h"

namespace agrid {
namespace {

constexpr double kBesideArea = 0.3;  // a door's middle may lie so far from the area it parts [m]

/// The nearest labelled pixel within reach; of several as near the first in row-major order.
std::optional<Pixel> labelledPixelNear(const Point2& point_map, const MapGeometry& geometry,
                                       const PixelLabels& labels) {
  const auto centre = geometry.pixelAt(point_map);
  if (!centre) return std::nullopt;
  const int reach = static_cast<int>(kBesideArea / geometry.resolution);
  std::optional<Pixel> nearest;
  int least = reach * reach + 1;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const Pixel p{centre->x + dx, centre->y + dy};
      const int squared = dx * dx + dy * dy;
      if (squared >= least || !geometry.contains(p) || labels[geometry.index(p)] == 0) continue;
      least = squared;
      nearest = p;
    }
  }
  return nearest;
}

std::vector<AreaGroup> groupsOf(const std::vector<std::size_t>& group_of) {
  std::vector<AreaGroup> groups;
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    if (group_of[i] == groups.size()) groups.emplace_back();
    groups[group_of[i]].members.push_back(static_cast<std::uint16_t>(i + 1));
  }
  return groups;
}

/// Puts a given door where no automatic one is into the group that it lies in.
void placeDoor(const DoorTag& tag, const OccupancyMap& map, const AutomaticAreas& automatic,
               Grouping& grouping) {
  const MapGeometry& geometry = map.geometry();
  const PixelLabels& labels = automatic.area_map.pixel_labels;
  const auto pixel = labelledPixelNear(tag.pose_map.position, geometry, labels);
  if (!pixel) {
    grouping.in_walls.push_back(tag);
    return;
  }
  GivenDoor door{tag.id, tag.pose_map, tag.width};
  if (geometry.pixelAt(tag.pose_map.position) != pixel) {
    door.pose_map.position = geometry.center(*pixel);
  }
  const std::size_t label = labels[geometry.index(*pixel)];
  grouping.groups[grouping.group_of[label - 1]].doors.push_back(door);
}

/// A group for each piece of free space that no automatic area has and a given area tag lies in.
void addIslands(const OccupancyMap& map, const AutomaticAreas& automatic, const Knowledge& known,
                Grouping& grouping) {
  const MapGeometry& geometry = map.geometry();
  std::set<std::size_t> taken;
  for (const AreaTag& tag : known.areas) {
    const auto pixel = geometry.pixelAt(tag.seed_map);
    if (tag.source == TagSource::kAutomatic || !pixel) continue;
    if (taken.count(geometry.index(*pixel)) > 0) continue;
    const auto island = islandAt(*pixel, map, automatic.area_map.pixel_labels);
    if (island.empty()) continue;
    taken.insert(island.begin(), island.end());
    grouping.groups.emplace_back();
    grouping.groups.back().seed_map = tag.seed_map;
  }
}

bool sameDoor(const GivenDoor& a, const GivenDoor& b) {
  return a.id == b.id && a.width == b.width && a.pose_map.yaw == b.pose_map.yaw &&
         a.pose_map.position == b.pose_map.position;
}

}  // namespace

std::uint16_t labelOf(const AutomaticAreas& automatic, AreaId id) {
  const auto& areas = automatic.area_map.areas;
  const auto found = std::lower_bound(areas.begin(), areas.end(), id,
                                      [](const Area& area, AreaId i) { return area.id < i; });
  return found == areas.end() || found->id != id
             ? std::uint16_t{0}
             : static_cast<std::uint16_t>(found - areas.begin() + 1);
}

bool partedAlike(const AreaGroup& a, const AreaGroup& b) {
  return a.members == b.members && a.seed_map == b.seed_map &&
         std::equal(a.doors.begin(), a.doors.end(), b.doors.begin(), b.doors.end(), sameDoor);
}

Grouping groupAreas(const OccupancyMap& map, const AutomaticAreas& automatic,
                    const Knowledge& known) {
  const AreaMap& areas = automatic.area_map;
  std::vector<const DoorTag*> said;  // by people
  for (const DoorTag& tag : known.doors) {
    if (tag.absent || tag.source != TagSource::kAutomatic) said.push_back(&tag);
  }
  const auto meant = doorsMeant(said, areas.doors, map.geometry().resolution);
  Grouping grouping;
  DisjointSets sets(areas.areas.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!meant[i] || !said[i]->absent) continue;
    grouping.absent_doors.push_back(*meant[i]);
    const auto& sides = areas.doors[*meant[i]].areas;
    const std::uint16_t a = labelOf(automatic, sides[0]);
    const std::uint16_t b = labelOf(automatic, sides[1]);
    if (a != 0 && b != 0) sets.unite(a - 1U, b - 1U);
  }
  std::sort(grouping.absent_doors.begin(), grouping.absent_doors.end());
  const std::vector<std::uint32_t> numbers = sets.numbers();
  grouping.group_of.assign(numbers.begin(), numbers.end());
  grouping.groups = groupsOf(grouping.group_of);
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!meant[i] && !said[i]->absent) placeDoor(*said[i], map, automatic, grouping);
  }
  addIslands(map, automatic, known, grouping);
  return grouping;
}

}  // namespace agrid
