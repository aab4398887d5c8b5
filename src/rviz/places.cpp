// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <cmath>

namespace agrid_map_rviz {
namespace {

using agrid_map::Tag;
using agrid_map::TopologicalGraph;

agrid_map::AddTag::Request tagWithId(const Place& place) {
  agrid_map::AddTag::Request request;
  request.tag.type = place.type;
  request.tag.id = place.id;
  request.tag.source = Tag::MANUAL;
  return request;
}

template <typename Thing>
QString nameIn(const std::vector<Thing>& things, std::uint32_t id) {
  const Thing* thing = find(things, id);
  return thing ? QString::fromStdString(thing->name) : QString();
}

/// The tag that makes an area again as it was.
Change again(const agrid_map::Area& area, const std::string& frame) {
  auto request = tagAt(Tag::AREA, frame, area.anchor.x, area.anchor.y);
  request.tag.name = area.name;
  request.tag.category = area.category;
  request.tag.properties = area.properties;
  return request;
}

Change again(const agrid_map::Object& object, const std::string& frame) {
  auto request = tagAt(Tag::OBJECT, frame, 0, 0);
  request.tag.name = object.name;
  request.tag.category = object.category;
  request.tag.pose = object.pose;
  request.tag.size = object.size;
  request.tag.properties = object.properties;
  return request;
}

std::vector<Change> again(const agrid_map::Door& door, const std::string& frame) {
  auto request = doorBetween(frame, door.jambs[0], door.jambs[1]);
  // a door of the geometry comes back under its id, and has a name of its own there
  if (door.source != Tag::AUTOMATIC) request.tag.name = door.name;
  request.tag.properties = door.properties;
  request.force = true;
  std::vector<Change> changes = {request};
  if (door.state != agrid_map::Door::UNKNOWN && door.source != Tag::AUTOMATIC) {
    agrid_map::SetDoor::Request state;
    state.door = door.name;
    state.state = door.state;
    changes.emplace_back(state);
  }
  return changes;
}

/// Undoes add_tag; `id` is the thing that the tag became or changed.
class InverseOfTag {
 public:
  InverseOfTag(const TopologicalGraph& before, const agrid_map::AddTag::Request& request,
               std::uint32_t id)
      : before_(before), tag_(request.tag), place_{request.tag.type, id} {}

  std::vector<Change> operator()() const {
    const std::string& frame = before_.header.frame_id;
    if (place_.type == Tag::AREA) {
      const agrid_map::Area* area = find(before_.areas, place_.id);
      if (!area || area->source == Tag::AUTOMATIC) return {removal(place_)};
      return restored(*area, again(*area, frame));
    }
    if (place_.type == Tag::OBJECT) {
      const agrid_map::Object* object = find(before_.objects, place_.id);
      if (!object || object->source == Tag::AUTOMATIC) return {removal(place_)};
      return restored(*object, again(*object, frame));
    }
    // taking a door back would take away one that geometry finds: it is named as before instead
    const agrid_map::Door* door = find(before_.doors, place_.id);
    if (!door) return {removal(place_)};
    return {rename(place_, door->name)};
  }

 private:
  /// An empty text leaves what was said, so a category that was not there goes with the tag.
  template <typename Thing>
  std::vector<Change> restored(const Thing& before, const Change& as_new) const {
    if (before.category.empty() && !tag_.category.empty()) return {removal(place_), as_new};
    Change change = as_new;
    std::get<agrid_map::AddTag::Request>(change).tag.id = place_.id;
    return {change};
  }

  const TopologicalGraph& before_;
  const Tag& tag_;
  Place place_;
};

}  // namespace

QString nameOf(const TopologicalGraph& graph, const Place& place) {
  if (place.type == Tag::AREA) return nameIn(graph.areas, place.id);
  if (place.type == Tag::DOOR) return nameIn(graph.doors, place.id);
  return place.type == Tag::OBJECT ? nameIn(graph.objects, place.id) : QString();
}

agrid_map::AddTag::Request tagAt(std::uint8_t type, const std::string& frame, double x, double y) {
  agrid_map::AddTag::Request request;
  request.tag.header.frame_id = frame;
  request.tag.type = type;
  request.tag.source = Tag::MANUAL;
  request.tag.pose.position.x = x;
  request.tag.pose.position.y = y;
  request.tag.pose.orientation.w = 1;
  return request;
}

agrid_map::AddTag::Request doorBetween(const std::string& frame, const geometry_msgs::Point& a,
                                       const geometry_msgs::Point& b) {
  auto request = tagAt(Tag::DOOR, frame, (a.x + b.x) / 2, (a.y + b.y) / 2);
  // the x axis leads through it, so its y axis lies along the jambs
  const double half_yaw = std::atan2(a.x - b.x, b.y - a.y) / 2;
  request.tag.pose.orientation.z = std::sin(half_yaw);
  request.tag.pose.orientation.w = std::cos(half_yaw);
  request.tag.size.y = std::hypot(b.x - a.x, b.y - a.y);
  return request;
}

Change rename(const Place& place, const std::string& name) {
  auto request = tagWithId(place);
  request.tag.name = name;
  return request;
}

Change setCategory(const Place& place, const std::string& category) {
  auto request = tagWithId(place);
  request.tag.category = category;
  return request;
}

Change setDoorState(std::uint32_t door, std::uint8_t state) {
  agrid_map::SetDoor::Request request;
  request.door = std::to_string(door);
  request.state = state;
  return request;
}

Change removal(const Place& place) {
  agrid_map::RemoveTag::Request request;
  request.type = place.type;
  request.id = place.id;
  return request;
}

std::vector<Change> joining(const TopologicalGraph& graph, std::uint32_t area_a,
                            std::uint32_t area_b) {
  std::vector<Change> changes;
  for (const agrid_map::Door& door : graph.doors) {
    const bool between = (door.areas[0] == area_a && door.areas[1] == area_b) ||
                         (door.areas[0] == area_b && door.areas[1] == area_a);
    if (between) changes.push_back(removal({Tag::DOOR, door.id}));
  }
  return changes;
}

std::vector<Change> inverseOf(const TopologicalGraph& before, const Change& change,
                              std::uint32_t id) {
  const std::string& frame = before.header.frame_id;
  if (const auto* tag = std::get_if<agrid_map::AddTag::Request>(&change)) {
    return InverseOfTag(before, *tag, id)();
  }
  if (const auto* state = std::get_if<agrid_map::SetDoor::Request>(&change)) {
    for (const agrid_map::Door& door : before.doors) {
      if (std::to_string(door.id) == state->door) return {setDoorState(door.id, door.state)};
    }
    return {};
  }
  const auto& removed = std::get<agrid_map::RemoveTag::Request>(change);
  if (removed.type == Tag::AREA) {
    const agrid_map::Area* area = find(before.areas, removed.id);
    // nothing was said of an automatic one
    if (!area || area->source == Tag::AUTOMATIC) return {};
    return {again(*area, frame)};
  }
  if (removed.type == Tag::OBJECT) {
    const agrid_map::Object* object = find(before.objects, removed.id);
    return object ? std::vector<Change>{again(*object, frame)} : std::vector<Change>{};
  }
  const agrid_map::Door* door = find(before.doors, removed.id);
  return door ? again(*door, frame) : std::vector<Change>{};
}

}  // namespace agrid_map_rviz
