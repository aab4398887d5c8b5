// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "agrid/semantic_map/object_area.h"
#include "agrid/semantic_map/object_cells.h"
#include "agrid_map_ros/conversions.h"
#include "ros/cell_occupancy.h"

namespace agrid_map_ros {
namespace {

std::vector<diagnostic_msgs::KeyValue> propertiesToMsg(const agrid::Properties& properties) {
  std::vector<diagnostic_msgs::KeyValue> msg;
  for (const auto& [key, value] : properties) {
    msg.emplace_back();
    msg.back().key = key;
    msg.back().value = value;
  }
  return msg;
}

agrid::Properties propertiesFromMsg(const std::vector<diagnostic_msgs::KeyValue>& msg) {
  agrid::Properties properties;
  for (const auto& pair : msg) properties[pair.key] = pair.value;
  return properties;
}

agrid::Point2 pointFromMsg(const geometry_msgs::Point& point) { return {point.x, point.y}; }

/// The enumerator with this value, if it is at most `last`.
template <typename Enum>
Enum enumFrom(std::uint8_t value, Enum last, const char* field) {
  if (value > static_cast<std::uint8_t>(last)) {
    throw std::invalid_argument(std::string(field) + " is " + std::to_string(value) +
                                ", allowed [0, " + std::to_string(static_cast<int>(last)) + "]");
  }
  return static_cast<Enum>(value);
}

}  // namespace

geometry_msgs::Point toMsg(const agrid::Point2& point) {
  geometry_msgs::Point msg;
  msg.x = point.x();
  msg.y = point.y();
  return msg;
}

geometry_msgs::Pose toMsg(const agrid::Pose2& pose) {
  geometry_msgs::Pose msg;
  msg.position = toMsg(pose.position);
  msg.orientation.z = std::sin(pose.yaw / 2);
  msg.orientation.w = std::cos(pose.yaw / 2);
  return msg;
}

agrid::Pose2 fromMsg(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  const double squared_norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return {pointFromMsg(pose.position),
          std::atan2(2 * (q.w * q.z + q.x * q.y), squared_norm - 2 * (q.y * q.y + q.z * q.z))};
}

agrid_map::AGrid gridToMsg(const agrid::SemanticMap& map, const Stamp& stamp) {
  agrid_map::AGrid msg;
  msg.header = stamp.header;
  msg.map_id = map.map().digest();
  msg.version = stamp.version;
  msg.origin = toMsg(map.grid().mapFromGrid());
  msg.x = map.grid().x();
  msg.y = map.grid().y();
  msg.labels.reserve(map.area_map.cell_areas.size());
  for (const agrid::AreaId id : map.area_map.cell_areas) {
    msg.labels.push_back(static_cast<std::uint32_t>(id));
  }
  msg.occupancy = cellOccupancy(map.map(), map.grid());
  return msg;
}

agrid::AGrid fromMsg(const agrid_map::AGrid& grid) {
  return agrid::AGrid(fromMsg(grid.origin), grid.x, grid.y);
}

agrid_map::Area toMsg(const agrid::Area& area) {
  agrid_map::Area msg;
  msg.id = static_cast<std::uint32_t>(area.id);
  msg.name = area.name;
  msg.category = area.category;
  msg.anchor = toMsg(area.anchor_map);
  for (const agrid::Point2& corner : area.outline_map) {
    msg.outline.points.emplace_back();
    msg.outline.points.back().x = static_cast<float>(corner.x());
    msg.outline.points.back().y = static_cast<float>(corner.y());
  }
  msg.size = area.size;
  msg.source = static_cast<std::uint8_t>(area.source);
  msg.properties = propertiesToMsg(area.properties);
  msg.category_guess = area.category_guess;
  return msg;
}

agrid::Area fromMsg(const agrid_map::Area& msg) {
  agrid::Area area;
  area.id = agrid::AreaId{msg.id};
  area.name = msg.name;
  area.category = msg.category;
  area.anchor_map = pointFromMsg(msg.anchor);
  for (const auto& corner : msg.outline.points) {
    area.outline_map.emplace_back(static_cast<double>(corner.x), static_cast<double>(corner.y));
  }
  area.size = msg.size;
  area.source = enumFrom(msg.source, agrid::TagSource::kInteraction, "source");
  area.properties = propertiesFromMsg(msg.properties);
  area.category_guess = msg.category_guess;
  return area;
}

agrid_map::Door toMsg(const agrid::Door& door) {
  agrid_map::Door msg;
  msg.id = static_cast<std::uint32_t>(door.id);
  msg.name = door.name;
  msg.kind = static_cast<std::uint8_t>(door.kind);
  msg.jambs = {toMsg(door.jambs_map.a), toMsg(door.jambs_map.b)};
  msg.width = door.width;
  msg.areas = {static_cast<std::uint32_t>(door.areas[0]),
               static_cast<std::uint32_t>(door.areas[1])};
  msg.state = static_cast<std::uint8_t>(door.state);
  msg.confidence = static_cast<float>(door.confidence);
  msg.source = static_cast<std::uint8_t>(door.source);
  msg.cells = door.cells;
  msg.properties = propertiesToMsg(door.properties);
  return msg;
}

agrid::Door fromMsg(const agrid_map::Door& msg) {
  agrid::Door door;
  door.id = agrid::DoorId{msg.id};
  door.name = msg.name;
  door.kind = enumFrom(msg.kind, agrid::DoorKind::kPassage, "kind");
  door.jambs_map = {pointFromMsg(msg.jambs[0]), pointFromMsg(msg.jambs[1])};
  door.width = msg.width;
  door.areas = {agrid::AreaId{msg.areas[0]}, agrid::AreaId{msg.areas[1]}};
  door.state = enumFrom(msg.state, agrid::DoorState::kClosed, "state");
  door.confidence = static_cast<double>(msg.confidence);
  door.source = enumFrom(msg.source, agrid::TagSource::kInteraction, "source");
  door.cells = msg.cells;
  door.properties = propertiesFromMsg(msg.properties);
  return door;
}

agrid_map::Object objectToMsg(const agrid::ObjectTag& object, const agrid::SemanticMap& map) {
  agrid_map::Object msg;
  msg.id = static_cast<std::uint32_t>(object.id);
  msg.name = object.name;
  msg.category = object.category;
  msg.pose = toMsg(object.pose_map);
  msg.size.x = object.size.x();
  msg.size.y = object.size.y();
  msg.size.z = object.height;
  const agrid::Area* area = agrid::areaOf(map, object);
  msg.area = area ? static_cast<std::uint32_t>(area->id) : 0;
  msg.cells = agrid::cellsOf(map, object);
  msg.source = static_cast<std::uint8_t>(object.source);
  msg.properties = propertiesToMsg(object.properties);
  return msg;
}

agrid_map::TopologicalGraph graphToMsg(const agrid::SemanticMap& map, const Stamp& stamp) {
  agrid_map::TopologicalGraph msg;
  msg.header = stamp.header;
  msg.map_id = map.map().digest();
  msg.version = stamp.version;
  for (const agrid::Area& area : map.area_map.areas) msg.areas.push_back(toMsg(area));
  for (const agrid::Door& door : map.area_map.doors) msg.doors.push_back(toMsg(door));
  for (const agrid::ObjectTag& object : map.knowledge.objects) {
    msg.objects.push_back(objectToMsg(object, map));
  }
  for (const agrid::PendingTag& pending : map.knowledge.pending) {
    msg.pending.push_back(tagOf(pending, stamp.header));
  }
  return msg;
}

nav_msgs::OccupancyGrid areasToMsg(const agrid::SemanticMap& map, const std_msgs::Header& header) {
  std::vector<std::int8_t> colors(map.area_map.areas.size() + 1, -1);
  for (std::size_t i = 0; i < map.area_map.areas.size(); ++i) {
    const auto id = static_cast<std::uint32_t>(map.area_map.areas[i].id);
    colors[i + 1] = static_cast<std::int8_t>(1 + id % 99);
  }
  nav_msgs::OccupancyGrid msg = toMsg(map.map(), header);
  std::transform(map.area_map.pixel_labels.begin(), map.area_map.pixel_labels.end(),
                 msg.data.begin(), [&](std::uint16_t label) { return colors[label]; });
  return msg;
}

namespace {

/// What areas, doors and objects have in common.
template <typename Thing>
agrid_map::Tag tagOfThing(const Thing& thing, std::uint8_t type, const std_msgs::Header& header) {
  agrid_map::Tag msg;
  msg.header = header;
  msg.type = type;
  msg.id = static_cast<std::uint32_t>(thing.id);
  msg.name = thing.name;
  msg.source = static_cast<std::uint8_t>(thing.source);
  msg.properties = propertiesToMsg(thing.properties);
  return msg;
}

}  // namespace

agrid_map::Tag tagOf(const agrid::Area& area, const std_msgs::Header& header) {
  agrid_map::Tag msg = tagOfThing(area, agrid_map::Tag::AREA, header);
  msg.category = area.category;
  msg.pose = toMsg(agrid::Pose2{area.anchor_map, 0});
  return msg;
}

agrid_map::Tag tagOf(const agrid::Door& door, const std_msgs::Header& header) {
  agrid_map::Tag msg = tagOfThing(door, agrid_map::Tag::DOOR, header);
  msg.pose = toMsg(agrid::poseOf(door));
  msg.size.y = door.width;
  return msg;
}

agrid_map::Tag tagOf(const agrid::ObjectTag& object, const std_msgs::Header& header) {
  agrid_map::Tag msg = tagOfThing(object, agrid_map::Tag::OBJECT, header);
  msg.category = object.category;
  msg.pose = toMsg(object.pose_map);
  msg.size.x = object.size.x();
  msg.size.y = object.size.y();
  msg.size.z = object.height;
  return msg;
}

agrid_map::Tag tagOf(const agrid::Thing& thing, const std_msgs::Header& header) {
  return std::visit([&header](const auto* held) { return tagOf(*held, header); }, thing);
}

namespace {

agrid_map::Tag tagOfWaiting(const agrid::AreaTag& area, const std_msgs::Header& header) {
  agrid_map::Tag msg = tagOfThing(area, agrid_map::Tag::AREA, header);
  msg.category = area.category;
  msg.pose = toMsg(agrid::Pose2{area.seed_map, 0});
  return msg;
}

agrid_map::Tag tagOfWaiting(const agrid::DoorTag& door, const std_msgs::Header& header) {
  agrid_map::Tag msg = tagOfThing(door, agrid_map::Tag::DOOR, header);
  msg.pose = toMsg(door.pose_map);
  msg.size.y = door.width;
  return msg;
}

agrid_map::Tag tagOfWaiting(const agrid::ObjectTag& object, const std_msgs::Header& header) {
  return tagOf(object, header);
}

}  // namespace

agrid_map::Tag tagOf(const agrid::PendingTag& pending, const std_msgs::Header& header) {
  std_msgs::Header own = header;
  if (!pending.frame_id.empty()) own.frame_id = pending.frame_id;
  agrid_map::Tag msg =
      std::visit([&own](const auto& tag) { return tagOfWaiting(tag, own); }, pending.tag);
  msg.properties.emplace_back();
  msg.properties.back().key = "pending";
  msg.properties.back().value = pending.reason;
  return msg;
}

}  // namespace agrid_map_ros
