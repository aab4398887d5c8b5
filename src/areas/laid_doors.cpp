// SPDX-License-Identifier: BSD-3-Clause
#include "areas/laid_doors.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "areas/cell_labels.h"
#include "areas/door_places.h"
#include "tags/default_name.h"

namespace agrid {
namespace {

constexpr double kUsualDoor = 0.9;  // in a wall, where no width is given [m]

bool isGiven(const DoorTag& tag) { return tag.source != TagSource::kAutomatic; }

class DoorLayer {
 public:
  DoorLayer(const OccupancyMap& map, const AutomaticAreas& automatic, const Grouping& grouping,
            const LaidAreas& areas)
      : geometry_(map.geometry()),
        automatic_(automatic),
        grouping_(grouping),
        areas_(areas),
        sides_(geometry_, areas.pixel_labels) {}

  /// The automatic doors that still lie between two areas, then those that lie in one.
  void addBorders(std::vector<Door>& between, std::vector<Door>& within) const {
    const auto& doors = automatic_.area_map.doors;
    for (std::size_t i = 0; i < doors.size(); ++i) {
      const auto& absent = grouping_.absent_doors;
      if (std::binary_search(absent.begin(), absent.end(), i)) continue;
      for (Door& door : asNow(doors[i])) {
        (door.areas[0] == door.areas[1] ? within : between).push_back(std::move(door));
      }
    }
  }

  /// A door that someone put into an area, or into a wall.
  Door given(const DoorTag& tag, Segment jambs_map) const {
    if (jambs_map.length() == 0) {
      const double half = (tag.width > 0 ? tag.width : kUsualDoor) / 2;
      jambs_map = {tag.pose_map * Point2(0, -half), tag.pose_map * Point2(0, half)};
    }
    Door door;
    door.jambs_map = jambs_map;
    door.width = jambs_map.length();
    const auto labels = sides_.beside(jambs_map);
    door.areas = {idOf(labels[0]), idOf(labels[1])};
    return door;
  }

 private:
  AreaId idOf(std::uint16_t label) const {
    return label == 0 ? AreaId{0} : areas_.areas[label - 1U].id;
  }

  /// An automatic door between the areas of now: one, or several where a given door meets it.
  std::vector<Door> asNow(const Door& automatic) const {
    const std::array<std::uint16_t, 2> labels{labelOf(automatic_, automatic.areas[0]),
                                              labelOf(automatic_, automatic.areas[1])};
    Door door = automatic;
    door.id = DoorId{0};  // its own means nothing outside
    door.name.clear();
    bool parted = false;
    for (const std::size_t side : {0U, 1U}) {
      if (labels[side] == 0) continue;
      const AreaGroup& group = areas_.groups[grouping_.group_of[labels[side] - 1U]];
      door.areas[side] = group.areas.front();
      parted = parted || group.areas.size() > 1;
    }
    if (!parted) return {door};
    const auto stretches = sides_.along(door.jambs_map, automatic_.area_map.pixel_labels, labels);
    std::vector<Door> doors;
    if (stretches.size() > 1) door.cells.clear();
    for (const DoorStretch& stretch : stretches) {
      if (stretches.size() > 1 && stretch.jambs_map.length() < automatic_.min_border_length)
        continue;
      if (stretches.size() > 1) door.jambs_map = stretch.jambs_map;
      door.width = stretches.size() > 1 ? stretch.jambs_map.length() : automatic.width;
      door.areas = {idOf(stretch.labels[0]), idOf(stretch.labels[1])};
      doors.push_back(door);
    }
    return doors;
  }

  const MapGeometry& geometry_;
  const AutomaticAreas& automatic_;
  const Grouping& grouping_;
  const LaidAreas& areas_;
  DoorSides sides_;
};

void say(const DoorTag& tag, Door& door) {
  door.id = tag.id;
  door.name = tag.name;
  door.state = tag.state;
  door.source = tag.source;
  door.properties = tag.properties;
  if (!isGiven(tag)) return;
  door.kind = DoorKind::kDoor;
  door.confidence = 1;
}

/// Tells the doors what the tags say that mean them.
/// @return the numbers of the tags that mean none
std::vector<const DoorTag*> sayAll(const std::vector<const DoorTag*>& tags, double resolution,
                                   std::vector<Door>& doors) {
  std::vector<const DoorTag*> rest;
  const auto meant = doorsMeant(tags, doors, resolution);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (meant[i]) {
      say(*tags[i], doors[*meant[i]]);
    } else {
      rest.push_back(tags[i]);
    }
  }
  return rest;
}

bool hasTag(const Door& door) { return door.id != DoorId{0}; }

/// A tag for each door, and the absent ones.
void keepTags(std::vector<Door>& doors, Knowledge& known) {
  std::set<std::string> names;
  std::vector<DoorTag> tags;
  for (const DoorTag& tag : known.doors) {
    names.insert(tag.name);
    if (tag.absent) tags.push_back(tag);
  }
  for (Door& door : doors) {
    const DoorTag* tag = hasTag(door) ? findTag(known, door.id) : nullptr;
    if (!tag) door.id = DoorId{known.next_ids.door++};
    if (door.name.empty()) {
      door.name = defaultName("door", static_cast<std::uint32_t>(door.id), names);
    }
    tags.push_back(tag && isGiven(*tag) ? *tag : tagOf(door));
    tags.back().name = door.name;
  }
  const auto byId = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(tags.begin(), tags.end(), byId);
  std::sort(doors.begin(), doors.end(), byId);
  known.doors = std::move(tags);
}

/// Doors that given tags put where no border was, with the tags' ids.
std::vector<Door> givenDoors(const DoorLayer& layer, const Grouping& grouping,
                             const LaidAreas& areas, const Knowledge& known) {
  std::vector<Door> doors;
  for (const AreaGroup& group : areas.groups) {
    for (std::size_t i = 0; i < group.doors.size(); ++i) {
      const DoorTag& tag = *findTag(known, group.doors[i].id);
      doors.push_back(layer.given(tag, group.jambs_map[i]));
      say(tag, doors.back());
    }
  }
  for (const DoorTag& tag : grouping.in_walls) {
    doors.push_back(layer.given(tag, {}));
    say(tag, doors.back());
  }
  return doors;
}

}  // namespace

std::vector<Door> layDoors(const OccupancyMap& map, const AGrid& grid,
                           const AutomaticAreas& automatic, const Grouping& grouping,
                           const LaidAreas& areas, Knowledge& known) {
  const DoorLayer layer(map, automatic, grouping, areas);
  const double resolution = map.geometry().resolution;
  std::vector<Door> doors = givenDoors(layer, grouping, areas, known);
  std::set<DoorId> placed;
  for (const Door& door : doors) placed.insert(door.id);
  std::vector<const DoorTag*> tags;
  for (const DoorTag& tag : known.doors) {
    if (!tag.absent && placed.count(tag.id) == 0) tags.push_back(&tag);
  }
  std::vector<Door> between;
  std::vector<Door> within;
  layer.addBorders(between, within);
  tags = sayAll(tags, resolution, between);
  tags.erase(
      std::remove_if(tags.begin(), tags.end(), [](const DoorTag* t) { return !isGiven(*t); }),
      tags.end());
  // a door that someone named stays, though it parts nothing
  tags = sayAll(tags, resolution, within);
  std::vector<DeferTag> waiting;
  for (const DoorTag* tag : tags) {
    waiting.push_back({{*tag, {}, "another door given by a person is where it is"}});
  }
  within.erase(
      std::remove_if(within.begin(), within.end(), [](const Door& d) { return !hasTag(d); }),
      within.end());
  for (std::vector<Door>* more : {&between, &within}) {
    doors.insert(doors.end(), std::make_move_iterator(more->begin()),
                 std::make_move_iterator(more->end()));
  }
  for (Door& door : doors) {
    if (door.cells.empty()) door.cells = cellsOnSegment(grid, door.jambs_map);
  }
  keepTags(doors, known);
  for (const DeferTag& tag : waiting) apply(tag, known);
  return doors;
}

}  // namespace agrid
