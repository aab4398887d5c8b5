// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/place.h"

#include <algorithm>

#include "agrid/semantic_map/object_area.h"

namespace agrid::dialogue {
namespace {

struct AreasOf {
  const SemanticMap& map;

  std::vector<AreaId> operator()(const Area* area) const { return {area->id}; }
  std::vector<AreaId> operator()(const Door* door) const {
    std::vector<AreaId> areas(door->areas.begin(), door->areas.end());
    areas.erase(std::remove(areas.begin(), areas.end(), AreaId{}), areas.end());
    return areas;
  }
  std::vector<AreaId> operator()(const ObjectTag* object) const {
    const Area* area = areaOf(map, *object);
    return area ? std::vector<AreaId>{area->id} : std::vector<AreaId>{};
  }
};

}  // namespace

Place placeOf(const SemanticMap& map, const Thing& thing) {
  return {thing, shapeOf(thing), positionOf(thing), std::visit(AreasOf{map}, thing)};
}

Place placeOf(const SemanticMap& map, const Pose2& robot) {
  Place place{std::nullopt, Shape({robot.position}), robot.position, {}};
  if (const Area* area = areaAt(map, robot.position)) place.areas = {area->id};
  return place;
}

bool shareAnArea(const Place& a, const Place& b) {
  return std::find_first_of(a.areas.begin(), a.areas.end(), b.areas.begin(), b.areas.end()) !=
         a.areas.end();
}

bool surrounds(const Place& area, const Place& inner) {
  return area.as<Area>() && !inner.as<Area>() && !inner.as<Door>() && shareAnArea(area, inner);
}

}  // namespace agrid::dialogue
