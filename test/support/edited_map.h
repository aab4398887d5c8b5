// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "agrid/pipeline.h"
#include "agrid/pipeline/edit.h"
#include "support/ascii_map.h"

namespace agrid::test {

/// A drawing at 5 cm from one at 0.25 m.
inline std::vector<std::string> fiveTimes(const std::vector<std::string>& rows) {
  std::vector<std::string> large;
  for (const std::string& row : rows) {
    std::string wide;
    for (const char c : row) wide += std::string(5, c);
    large.insert(large.end(), 5, wide);
  }
  return large;
}

/// Two rooms of 4 x 4.5 m beside each other with a door of 1 m between them, at (4.625, 2.5), a
/// closet without a door, and unknown space to the right; at 5 cm.
inline std::vector<std::string> twoRoomsDrawing() {
  std::vector<std::string> rows(20, "#................#................#");
  for (std::size_t y = 8; y < 12; ++y) rows[y][17] = '.';
  const std::string wall(35, '#');
  rows.front() = rows.back() = wall;
  for (std::string& row : rows) row += "????";
  return fiveTimes(rows);
}

inline SemanticMap annotated(const OccupancyGrid& grid, const Knowledge& known = {}) {
  const PipelineParams params;
  const auto structure = extractStructure(std::make_shared<const OccupancyMap>(grid), params);
  SemanticMap map = annotate(structure, known, params);
  for (const Door& door : map.area_map.doors) {  // every door has a tag
    if (findTag(map.knowledge, door.id)) continue;
    const Point2 along = door.jambs_map.b - door.jambs_map.a;
    DoorTag tag;
    tag.id = door.id;
    tag.name = door.name;
    tag.pose_map = {door.jambs_map.midpoint(), std::atan2(-along.x(), along.y())};
    tag.width = door.width;
    apply(PutTag{tag}, map.knowledge);
  }
  return map;
}

/// A map that is edited without being laid out again: what is known changes, its areas do not.
class EditedMap {
 public:
  explicit EditedMap(SemanticMap map) : map_(std::move(map)) {}
  EditedMap() : EditedMap(annotated(asciiGrid(twoRoomsDrawing(), 0.05))) {}

  Edit edit(const EditRequest& request, const EditParams& params = {}) {
    Edit edit = decide(request, map_, params);
    for (const Change& change : edit.changes) apply(change, map_.knowledge);
    return edit;
  }
  SemanticMap& map() { return map_; }
  Knowledge& known() { return map_.knowledge; }

 private:
  SemanticMap map_;
};

inline AddTag areaAt(const Point2& point, const std::string& name = {}) {
  AreaTag tag;
  tag.name = name;
  tag.seed_map = point;
  tag.source = TagSource::kManual;
  return {tag};
}

inline AddTag doorAt(const Pose2& pose, const std::string& name = {}) {
  DoorTag tag;
  tag.name = name;
  tag.pose_map = pose;
  tag.source = TagSource::kManual;
  return {tag};
}

inline AddTag objectAt(const Pose2& pose, const std::string& name = {}) {
  ObjectTag tag;
  tag.name = name;
  tag.pose_map = pose;
  return {tag};
}

}  // namespace agrid::test
