// SPDX-License-Identifier: BSD-3-Clause
#include "tools/place_view.h"

#include <algorithm>

#include "agrid/semantic_map/object_area.h"
#include "identity/polygon_lookup.h"

namespace agrid::tools {
namespace {

constexpr double kReach = 0.6;  // [m] from a door's middle: half of a thick wall and an offset
constexpr int kSteps = 24;

/// The areas along a ray from a door, the nearest first, each once.
std::vector<std::size_t> areasAlong(const Pose2& ray, const OutlineIndex& outlines) {
  std::vector<std::size_t> areas;
  for (int step = 1; step <= kSteps; ++step) {
    const auto area = outlines.smallestAt(ray * Point2(kReach * step / kSteps, 0));
    if (area && std::count(areas.begin(), areas.end(), *area) == 0) areas.push_back(*area);
  }
  return areas;
}

using Sides = std::array<std::optional<std::size_t>, 2>;

Sides sidesOf(const Pose2& door, const OutlineIndex& outlines) {
  const std::vector<std::size_t> ahead = areasAlong(door, outlines);
  const std::vector<std::size_t> behind = areasAlong({door.position, door.yaw + M_PI}, outlines);
  Sides sides;
  if (!ahead.empty()) sides[0] = ahead.front();
  if (!behind.empty()) sides[1] = behind.front();
  if (!sides[0] || sides[0] != sides[1]) return sides;
  // a door that was put down beside its opening has one area on both sides at first
  if (behind.size() > 1) return {ahead.front(), behind[1]};
  if (ahead.size() > 1) return {ahead[1], behind.front()};
  return sides;
}

std::optional<AreaTag> tagOf(const SemanticMap& map, AreaId id) {
  if (const AreaTag* tag = findTag(map.knowledge, id)) return *tag;
  return std::nullopt;
}

}  // namespace

PlaceView viewOfOutlines(const Knowledge& knowledge) {
  PlaceView view;
  view.knowledge = knowledge;
  view.seeds = knowledge.areas;
  const OutlineIndex outlines(knowledge.areas);
  for (const DoorTag& door : knowledge.doors) {
    if (door.absent) continue;
    PlaceView::DoorSides& found = view.doors.emplace_back();
    found.door = door;
    const Sides sides = sidesOf(door.pose_map, outlines);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i]) found.areas[i] = knowledge.areas[*sides[i]];
    }
  }
  for (const AreaTag& area : knowledge.areas) {
    const auto owner = outlines.smallestAt(area.seed_map);
    view.at_seed.push_back(owner ? knowledge.areas[*owner].id : AreaId{0});
  }
  for (const ObjectTag& object : knowledge.objects) {
    if (!outlines.smallestAt(object.pose_map.position)) view.lost_objects.push_back(object);
  }
  return view;
}

PlaceView viewOfMap(const SemanticMap& map, const Knowledge& laid) {
  PlaceView view;
  view.knowledge = map.knowledge;
  view.warnings = map.area_map.warnings;
  for (const Door& door : map.area_map.doors) {
    PlaceView::DoorSides& found = view.doors.emplace_back();
    if (const DoorTag* tag = findTag(map.knowledge, door.id)) found.door = *tag;
    found.door.id = door.id;
    found.areas = {tagOf(map, door.areas[0]), tagOf(map, door.areas[1])};
  }
  view.seeds = laid.areas;
  for (const AreaTag& tag : laid.areas) {
    const Area* area = areaAt(map, tag.seed_map);
    view.at_seed.push_back(area ? area->id : AreaId{0});
  }
  for (const ObjectTag& object : map.knowledge.objects) {
    if (!areaOf(map, object)) view.lost_objects.push_back(object);
  }
  return view;
}

}  // namespace agrid::tools
