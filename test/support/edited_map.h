// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

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

/// Two rooms of 4 x 4.5 m beside each other with a door of 1 m between them at (4.375, 2.5), and
/// unknown space beyond x = 8.75; at 5 cm.
inline std::vector<std::string> twoRoomsDrawing() {
  std::vector<std::string> rows(20, "#................#................#");
  for (std::size_t y = 8; y < 12; ++y) rows[y][17] = '.';
  const std::string wall(35, '#');
  rows.front() = rows.back() = wall;
  for (std::string& row : rows) row += "????";
  return fiveTimes(rows);
}

inline SemanticMap annotated(const OccupancyGrid& grid) {
  const PipelineParams params;
  const auto structure = extractStructure(std::make_shared<const OccupancyMap>(grid), params);
  return annotate(structure, {}, params);
}

/// A map to which edits are made.
class EditedMap {
 public:
  explicit EditedMap(SemanticMap map) : map_(std::move(map)) {}
  EditedMap() : EditedMap(annotated(asciiGrid(twoRoomsDrawing(), 0.05))) {}

  Edit edit(const EditRequest& request, const EditParams& params = {}) {
    Edit edit = decide(request, map_, params);
    Knowledge known = map_.knowledge;
    for (const Change& change : edit.changes) apply(change, known);
    if (edit.changed()) map_ = retag(map_, known);
    return edit;
  }
  const SemanticMap& map() const { return map_; }
  const Knowledge& known() const { return map_.knowledge; }

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

/// Expects that an edit is refused with this code and a text that holds `part`, and changes
/// nothing.
inline void expectRefused(EditErrorCode code, const std::string& part, const EditRequest& request,
                          EditedMap& map, const EditParams& params = {}) {
  const Knowledge before = map.known();
  try {
    map.edit(request, params);
    ADD_FAILURE() << "accepted, expected: " << part;
  } catch (const EditError& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << error.what() << "' does not tell '" << part << "'";
  }
  EXPECT_TRUE(difference(before, map.known()).empty());
}

/// Expects that a request changes nothing any more and is answered with this id.
inline void expectKnown(std::uint32_t id, const EditRequest& request, EditedMap& map) {
  const Edit again = map.edit(request);
  EXPECT_FALSE(again.changed()) << again.message;
  EXPECT_EQ(again.id, id);
}

}  // namespace agrid::test
