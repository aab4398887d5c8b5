// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "agrid/areas/pixel_labels.h"
#include "agrid/geometry/polygon.h"
#include "agrid/geometry/pose2.h"
#include "agrid/geometry/segment.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// A functional area (paper, 3.2).
struct Area {
  AreaId id{};
  std::string name;
  std::string category;        ///< as given by a person or robot; empty: none is
  std::string category_guess;  ///< "corridor", "room", "hall" or "closet", from its geometry alone
  Point2 anchor_map = Point2::Zero();  ///< free point of the area farthest from its walls [m]
  double anchor_clearance = 0;         ///< distance of the anchor from the nearest wall [m]
  Polygon outline_map;                 ///< outer boundary
  double size = 0;                     ///< of its free pixels [m^2]
  TagSource source = TagSource::kAutomatic;
  Properties properties;
};

/// Whether a border between two areas can be shut; the values are those of agrid_map/Door.
enum class DoorKind : std::uint8_t { kDoor = 0, kPassage = 1 };

/// A border between two areas.
struct Door {
  DoorId id{};
  std::string name;
  DoorKind kind = DoorKind::kDoor;
  Segment jambs_map;              ///< from jamb to jamb
  double width = 0;               ///< clear width [m]
  std::array<AreaId, 2> areas{};  ///< on either side; AreaId{0}: outside
  DoorState state = DoorState::kUnknown;
  double confidence = 0;  ///< [0, 1]; 1 for tags given by a person
  TagSource source = TagSource::kAutomatic;
  std::vector<std::uint32_t> cells;  ///< cells of the A-Grid that it covers, row-major, sorted
  Properties properties;
};

/// The pose that a tag would give a door: the middle between its jambs, x leading through it.
inline Pose2 poseOf(const Door& door) {
  const Point2 along = door.jambs_map.b - door.jambs_map.a;
  return {door.jambs_map.midpoint(), std::atan2(-along.x(), along.y())};
}

/// Areas and doors of a map, and which pixel and cell belongs to which area.
struct AreaMap {
  std::vector<Area> areas;
  std::vector<Door> doors;
  /// Row-major like the metric map: 0 = no area, k = areas[k - 1]; not 0 only on free pixels.
  PixelLabels pixel_labels;
  /// Row-major like the A-Grid: the area that has most of the cell's free pixels (a tie: the lowest
  /// id), AreaId{0} if none has any.
  std::vector<AreaId> cell_areas;
  std::vector<std::string> warnings;  ///< why there are no areas, which tags were not used ...
};

}  // namespace agrid
