// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "agrid/geometry/polygon.h"
#include "agrid/geometry/pose2.h"

namespace agrid {

enum class AreaId : std::uint32_t {};    ///< AreaId{0}: no area
enum class DoorId : std::uint32_t {};    ///< DoorId{0}: no door
enum class ObjectId : std::uint32_t {};  ///< ObjectId{0}: no object

/// Who said something about the map; the values are those of agrid_map/Tag.
enum class TagSource : std::uint8_t { kAutomatic = 0, kManual = 1, kInteraction = 2 };

/// What people know about a door; the values are those of agrid_map/Door.
enum class DoorState : std::uint8_t { kUnknown = 0, kOpen = 1, kClosed = 2 };

/// Free-form facts such as cost, alias or floor.
using Properties = std::map<std::string, std::string>;

/// "This point lies in that area": the seed an area grows from (paper, 3.2).
struct AreaTag {
  AreaId id{};
  std::string name;  ///< empty: a default one
  std::string category;
  Point2 seed_map = Point2::Zero();  ///< [m]
  TagSource source = TagSource::kAutomatic;
  Properties properties;
  /// Outer boundary of the area when it was last found, to know it again; empty: it never was.
  Polygon outline_map = {};
};

/// "There is a door here" (paper, 3.2): it closes the areas on both sides against each other.
struct DoorTag {
  DoorId id{};
  std::string name;  ///< empty: a default one
  Pose2 pose_map;    ///< its centre; x leads through it
  double width = 0;  ///< [m]; 0: up to the walls
  DoorState state = DoorState::kUnknown;
  TagSource source = TagSource::kAutomatic;
  Properties properties;
  /// "There is no door here": the areas on both sides are one.
  bool absent = false;
};

/// "There is a thing here" (paper, 4).
struct ObjectTag {
  ObjectId id{};
  std::string name;
  std::string category;
  Pose2 pose_map;                ///< its centre
  Point2 size = Point2::Zero();  ///< bounding box along its own axes [m]
  double height = 0;             ///< [m]
  TagSource source = TagSource::kManual;
  Properties properties;
};

/// A statement about the map by a person, by a robot with a person, or by the heuristics.
using Tag = std::variant<AreaTag, DoorTag, ObjectTag>;

// whether all that is said is the same, bit for bit
bool operator==(const AreaTag& a, const AreaTag& b);
bool operator==(const DoorTag& a, const DoorTag& b);
bool operator==(const ObjectTag& a, const ObjectTag& b);

}  // namespace agrid
