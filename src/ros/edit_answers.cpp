// SPDX-License-Identifier: BSD-3-Clause
#include "ros/edit_answers.h"

#include <cmath>
#include <utility>

#include <ros/serialization.h>

#include "agrid/exchange/export.h"
#include "agrid/planning/way.h"
#include "agrid/semantic_map/thing_lookup.h"
#include "ros/request_error.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

agrid::TagSource sourceOf(const agrid_map::Tag& tag) {
  if (tag.source <= agrid_map::Tag::INTERACTION) return static_cast<agrid::TagSource>(tag.source);
  throw RequestError(Status::INVALID_REQUEST,
                     "source is " + std::to_string(tag.source) + ", allowed [0, 2]");
}

/// Before any text of it is copied; more than all that a tag may hold.
void requireBounded(const agrid_map::Tag& tag) {
  constexpr std::uint32_t kMostBytes = 1U << 20U;
  const std::uint32_t bytes = ros::serialization::serializationLength(tag);
  if (bytes <= kMostBytes) return;
  throw RequestError(
      Status::INVALID_REQUEST,
      "the tag has " + std::to_string(bytes) + " bytes, allowed are " + std::to_string(kMostBytes));
}

void requireFinite(const geometry_msgs::Vector3& size) {
  if (std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z)) return;
  throw RequestError(Status::INVALID_REQUEST, "the size (" + formatNumber(size.x) + ", " +
                                                  formatNumber(size.y) + ", " +
                                                  formatNumber(size.z) + ") is not finite");
}

agrid::Properties propertiesOf(const agrid_map::Tag& tag) {
  agrid::Properties properties;
  for (const auto& pair : tag.properties) properties[pair.key] = pair.value;
  return properties;
}

agrid::Tag withPose(const agrid_map::Tag& msg, const agrid::Pose2& pose_map) {
  if (msg.type == agrid_map::Tag::AREA) {
    agrid::AreaTag tag;
    tag.id = agrid::AreaId{msg.id};
    tag.seed_map = pose_map.position;
    tag.category = msg.category;
    return tag;
  }
  if (msg.type == agrid_map::Tag::DOOR) {
    agrid::DoorTag tag;
    tag.id = agrid::DoorId{msg.id};
    tag.pose_map = pose_map;
    tag.width = msg.size.y;
    return tag;
  }
  if (msg.type == agrid_map::Tag::OBJECT) {
    agrid::ObjectTag tag;
    tag.id = agrid::ObjectId{msg.id};
    tag.pose_map = pose_map;
    tag.size = {msg.size.x, msg.size.y};
    tag.height = msg.size.z;
    tag.category = msg.category;
    return tag;
  }
  throw RequestError(Status::INVALID_REQUEST, "type is " + std::to_string(msg.type) +
                                                  ", allowed: 1 (area), 2 (door), 3 (object)");
}

bool saysNothing(const agrid_map::Tag& tag) {
  const auto& p = tag.pose.position;
  return tag.id != 0 && tag.header.frame_id.empty() && isZero(tag.pose.orientation) && p.x == 0 &&
         p.y == 0 && p.z == 0;
}

const char* wordFor(agrid::TagKind kind) {
  return kind == agrid::TagKind::kArea ? "area" : kind == agrid::TagKind::kDoor ? "door" : "object";
}

std::uint32_t onlyOne(const std::vector<std::uint32_t>& ids, const std::string& name,
                      agrid::TagKind kind) {
  if (ids.size() == 1) return ids.front();
  if (ids.empty()) {
    throw RequestError(Status::UNKNOWN_NAME,
                       std::string("no ") + wordFor(kind) + " is called '" + printable(name) + "'");
  }
  throw RequestError(Status::INVALID_REQUEST, "'" + printable(name) + "' means " +
                                                  std::to_string(ids.size()) +
                                                  " things; give the id of one");
}

/// The id of the only thing of a kind that has a name; what waits has one, too.
std::uint32_t idCalled(const Snapshot& snapshot, const std::string& name, agrid::TagKind kind) {
  std::vector<std::uint32_t> ids;
  for (const agrid::PendingTag& pending : snapshot.map->knowledge.pending) {
    if (agrid::kindOf(pending.tag) == kind && agrid::nameOf(pending.tag) == name) {
      ids.push_back(agrid::idOf(pending.tag));
    }
  }
  if (!ids.empty()) return onlyOne(ids, name, kind);
  for (const agrid::Thing& thing : agrid::findThings(*snapshot.map, name, {true, false}).things) {
    if (agrid::kindOf(thing) == kind) ids.push_back(agrid::idOf(thing));
  }
  return onlyOne(ids, name, kind);
}

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() < 10 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

/// A door's name, or its id as text.
std::uint32_t doorMeant(const Snapshot& snapshot, const std::string& word) {
  for (const agrid::Door& door : snapshot.map->area_map.doors) {
    if (door.name == word) return static_cast<std::uint32_t>(door.id);
  }
  if (isNumber(word)) return static_cast<std::uint32_t>(std::stoul(word));
  return idCalled(snapshot, word, agrid::TagKind::kDoor);
}

/// The name under which a map is stored, from that of its file.
std::string storedName(const std::string& file) {
  const std::string ending = ".yaml";
  const std::size_t stem = file.size() < ending.size() ? 0 : file.size() - ending.size();
  if (stem > 0 && file.compare(stem, ending.size(), ending) == 0) return file.substr(0, stem);
  throw RequestError(Status::INVALID_REQUEST,
                     "'" + printable(file.substr(0, 64)) +
                         "' does not end in .yaml, nor in the ending of another format");
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    text += (text.empty() ? "" : "; ") + printable(sentence);
  }
  return text;
}

bool wanted(const agrid_map::Tag& tag, const agrid_map::ListTags::Request& request) {
  return (request.type == 0 || request.type == tag.type) &&
         (request.category.empty() || request.category == tag.category);
}

}  // namespace

agrid::EditParams editParams(const Parameters& parameters) {
  agrid::EditParams params = parameters.edits;
  params.max_door_width = parameters.pipeline.areas.max_door_width;
  params.max_clutter_diagonal = parameters.pipeline.areas.max_clutter_diagonal;
  return params;
}

agrid::AddTag tagFromMsg(const Frames& frames, const agrid_map::Tag& msg) {
  requireBounded(msg);
  agrid::AddTag add;
  agrid::Pose2 pose_map;
  if (saysNothing(msg)) {
    add.placement = agrid::Placement::kUnchanged;
  } else {
    geometry_msgs::PoseStamped pose;
    pose.header = msg.header;
    pose.pose = msg.pose;
    const agrid::PlanPoint point = frames.planPoint(pose);
    pose_map = {point.position_map, point.yaw.value_or(0)};
    add.placement = point.yaw ? agrid::Placement::kPose : agrid::Placement::kAnyHeading;
  }
  requireFinite(msg.size);
  add.tag = withPose(msg, pose_map);
  std::visit(
      [&msg](auto& tag) {
        tag.name = msg.name;
        tag.source = sourceOf(msg);
        tag.properties = propertiesOf(msg);
      },
      add.tag);
  return add;
}

agrid_map::AddTag::Response answerAddTag(const Ground& ground, PlaceKeeper& keeper,
                                         const agrid_map::AddTag::Request& request) {
  agrid::AddTag add = tagFromMsg(ground.frames, request.tag);
  add.replace = request.replace;
  add.force = request.force;
  const auto answer = keeper.edit([&add](const Snapshot& snapshot) {
    return agrid::decide(add, *snapshot.map, editParams(*snapshot.parameters));
  });
  agrid_map::AddTag::Response response;
  response.status.message = printable(answer.message);
  response.id = answer.id;
  return response;
}

agrid_map::RemoveTag::Response answerRemoveTag(const Ground&, PlaceKeeper& keeper,
                                               const agrid_map::RemoveTag::Request& request) {
  if (request.type < agrid_map::Tag::AREA || request.type > agrid_map::Tag::OBJECT) {
    throw RequestError(Status::INVALID_REQUEST, "type is " + std::to_string(request.type) +
                                                    ", allowed: 1 (area), 2 (door), 3 (object)");
  }
  const auto kind = static_cast<agrid::TagKind>(request.type);
  const auto answer = keeper.edit([&](const Snapshot& snapshot) {
    const std::uint32_t id = request.id != 0 ? request.id : idCalled(snapshot, request.name, kind);
    return agrid::decide(agrid::RemoveTag{kind, id}, *snapshot.map,
                         editParams(*snapshot.parameters));
  });
  agrid_map::RemoveTag::Response response;
  response.status.message = printable(answer.message);
  return response;
}

agrid_map::SetDoor::Response answerSetDoor(const Ground&, PlaceKeeper& keeper,
                                           const agrid_map::SetDoor::Request& request) {
  if (request.state > agrid_map::Door::CLOSED) {
    throw RequestError(Status::INVALID_REQUEST, "state is " + std::to_string(request.state) +
                                                    ", allowed: 0 (unknown), 1 (open), 2 (closed)");
  }
  const auto state = static_cast<agrid::DoorState>(request.state);
  const auto answer = keeper.edit([&](const Snapshot& snapshot) {
    const agrid::DoorId id{doorMeant(snapshot, request.door)};
    return agrid::decide(agrid::SetDoor{id, state, agrid::TagSource::kManual}, *snapshot.map,
                         editParams(*snapshot.parameters));
  });
  agrid_map::SetDoor::Response response;
  response.status.message = printable(answer.message);
  return response;
}

agrid_map::SaveMap::Response answerSaveMap(const Ground& ground, PlaceKeeper& keeper,
                                           const agrid_map::SaveMap::Request& request) {
  agrid_map::SaveMap::Response response;
  const auto format = agrid::formatOfFile(request.name);
  if (!format) {
    keeper.saveAs(storedName(request.name));
    return response;
  }
  agrid::checkedName(request.name);  // before the work
  agrid::ExportParams params;
  params.frame_id = ground.snapshot.frame();
  params.find_way = [&](const agrid::Point2& from, const agrid::Point2& to) {
    return agrid::wayBetween(*ground.snapshot.planner, from, to);
  };
  const agrid::Exported exported = agrid::exportMap(*ground.snapshot.map, *format, params);
  keeper.saveBeside(request.name, exported.bytes);
  response.status.message = joined(exported.warnings);
  return response;
}

agrid_map::LoadMap::Response answerLoadMap(const Ground&, PlaceKeeper& keeper,
                                           const agrid_map::LoadMap::Request& request) {
  agrid_map::LoadMap::Response response;
  response.status.message = joined(keeper.load(storedName(request.name)));
  return response;
}

agrid_map::ListTags::Response answerListTags(const Ground& ground,
                                             const agrid_map::ListTags::Request& request) {
  const agrid::SemanticMap& map = *ground.snapshot.map;
  const std_msgs::Header& header = ground.snapshot.stamp.header;
  agrid_map::ListTags::Response response;
  const auto add = [&](const agrid_map::Tag& tag) {
    if (wanted(tag, request)) response.tags.push_back(tag);
  };
  for (const agrid::Area& area : map.area_map.areas) add(tagOf(area, header));
  for (const agrid::Door& door : map.area_map.doors) add(tagOf(door, header));
  for (const agrid::ObjectTag& object : map.knowledge.objects) add(tagOf(object, header));
  for (const agrid::PendingTag& pending : map.knowledge.pending) add(tagOf(pending, header));
  return response;
}

}  // namespace agrid_map_ros
