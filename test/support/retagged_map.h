// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "agrid/pipeline.h"

namespace agrid::test {

inline Structure structureOf(const OccupancyMap& map) {
  return extractStructure(std::make_shared<const OccupancyMap>(map), {});
}

inline DoorTag doorAt(std::uint32_t id, const Point2& at, double yaw = 0) {
  DoorTag tag;
  tag.id = DoorId{id};
  tag.name = "given_" + std::to_string(id);
  tag.pose_map = {at, yaw};
  tag.source = TagSource::kManual;
  return tag;
}

inline AreaTag areaAtSeed(std::uint32_t id, const std::string& name, const Point2& seed) {
  AreaTag tag;
  tag.id = AreaId{id};
  tag.name = name;
  tag.seed_map = seed;
  tag.source = TagSource::kManual;
  return tag;
}

inline SemanticMap after(const SemanticMap& map, const std::vector<Change>& changes) {
  Knowledge known = map.knowledge;
  for (const Change& change : changes) apply(change, known);
  return retag(map, known);
}

}  // namespace agrid::test
