// SPDX-License-Identifier: BSD-3-Clause
#include "storage/tag_text.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

#include "storage/flow_text.h"

namespace agrid {
namespace {

template <typename Enumerator, std::size_t N>
std::string word(Enumerator value, const std::array<std::string_view, N>& words) {
  return std::string(words.at(static_cast<std::size_t>(value)));
}

std::string list(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "[" : ", ") + numberText(number);
  return text + "]";
}

std::string list(const Pose2& pose) {
  return list({pose.position.x(), pose.position.y(), pose.yaw});
}

std::string list(const Point2& point) { return list({point.x(), point.y()}); }

std::string list(const Polygon& polygon) {
  std::string text = "[";
  for (const Point2& corner : polygon) text += (text.size() > 1 ? ", " : "") + list(corner);
  return text + "]";
}

std::string propertiesText(const Properties& properties) {
  if (properties.empty()) return "";
  std::string text;
  for (const auto& [key, value] : properties) {
    text += (text.empty() ? ", properties: {" : ", ") + quoted(key) + ": " + quoted(value);
  }
  return text + "}";
}

template <typename T>
std::string start(const T& tag) {
  return "id: " + std::to_string(static_cast<std::uint32_t>(tag.id)) +
         ", name: " + quoted(tag.name);
}

std::string fields(const AreaTag& tag) {
  return start(tag) + ", category: " + quoted(tag.category) + ", seed: " + list(tag.seed_map) +
         ", source: " + word(tag.source, kSourceWords) + propertiesText(tag.properties) +
         (tag.outline_map.empty() ? "" : ", outline: " + list(tag.outline_map));
}

std::string fields(const DoorTag& tag) {
  return start(tag) + ", pose: " + list(tag.pose_map) + ", width: " + numberText(tag.width) +
         ", state: " + word(tag.state, kStateWords) +
         ", source: " + word(tag.source, kSourceWords) + (tag.absent ? ", absent: true" : "") +
         propertiesText(tag.properties);
}

std::string fields(const ObjectTag& tag) {
  return start(tag) + ", category: " + quoted(tag.category) + ", pose: " + list(tag.pose_map) +
         ", size: " + list(tag.size) + ", height: " + numberText(tag.height) +
         ", source: " + word(tag.source, kSourceWords) + propertiesText(tag.properties);
}

std::string fields(const Tag& tag) {
  return std::visit([](const auto& t) { return fields(t); }, tag);
}

std::string fields(const PendingTag& pending) {
  return "frame_id: " + quoted(pending.frame_id) + ", reason: " + quoted(pending.reason) + ", " +
         fields(pending.tag);
}

struct ChangeFields {
  std::string operator()(const PutTag& put) const {
    return "put: " + std::string(wordOf(kindOf(put.tag))) + ", " + fields(put.tag);
  }
  std::string operator()(const DropTag& drop) const {
    return "drop: " + std::string(wordOf(drop.kind)) + ", id: " + std::to_string(drop.id);
  }
  std::string operator()(const DeferTag& defer) const {
    return "defer: " + std::string(wordOf(kindOf(defer.pending.tag))) + ", " +
           fields(defer.pending);
  }
  std::string operator()(const ReserveIds& reserve) const {
    return "reserve: " + flowText(reserve.next_ids);
  }
};

void checkId(TagKind kind, std::uint32_t id) {
  if (id != 0 && id != std::numeric_limits<std::uint32_t>::max()) return;
  throw std::invalid_argument("cannot store " + std::string(wordOf(kind)) + " " +
                              std::to_string(id) + ": its id is not in [1, 4294967294]");
}

void checkIds(const NextIds& ids) {
  if (ids.area > 0 && ids.door > 0 && ids.object > 0) return;
  throw std::invalid_argument("cannot store next_ids: 0, allowed is 1 or more");
}

[[noreturn]] void refuse(const Tag& tag, const std::string& what) {
  throw std::invalid_argument("cannot store " + std::string(wordOf(kindOf(tag))) + " " +
                              std::to_string(idOf(tag)) + ": " + what);
}

bool isFinite(const Pose2& pose) { return pose.position.allFinite() && std::isfinite(pose.yaw); }

struct Check {
  const Tag& tag;

  void operator()(const AreaTag& area) const {
    if (!area.seed_map.allFinite()) refuse(tag, "seed_map is not finite");
    for (const Point2& corner : area.outline_map) {
      if (!corner.allFinite()) refuse(tag, "outline_map is not finite");
    }
    checkWord(area.source);
  }
  void operator()(const DoorTag& door) const {
    if (!isFinite(door.pose_map)) refuse(tag, "pose_map is not finite");
    checkLength("width", door.width);
    if (door.state > DoorState::kClosed) refuse(tag, "state is none of DoorState");
    checkWord(door.source);
  }
  void operator()(const ObjectTag& object) const {
    if (!isFinite(object.pose_map)) refuse(tag, "pose_map is not finite");
    checkLength("size.x", object.size.x());
    checkLength("size.y", object.size.y());
    checkLength("height", object.height);
    checkWord(object.source);
  }

  void checkLength(const char* field, double length) const {
    if (std::isfinite(length) && length >= 0) return;
    refuse(tag, std::string(field) + " is " + numberText(length) + ", allowed is 0 or more");
  }
  void checkWord(TagSource source) const {
    if (source > TagSource::kInteraction) refuse(tag, "source is none of TagSource");
  }
};

}  // namespace

std::string_view wordOf(TagKind kind) { return kKindWords.at(static_cast<std::size_t>(kind) - 1); }

std::string flowText(const Tag& tag) { return "{" + fields(tag) + "}"; }

std::string flowText(const PendingTag& pending) {
  return "{kind: " + std::string(wordOf(kindOf(pending.tag))) + ", " + fields(pending) + "}";
}

std::string flowText(const NextIds& ids) {
  return "{area: " + std::to_string(ids.area) + ", door: " + std::to_string(ids.door) +
         ", object: " + std::to_string(ids.object) + "}";
}

std::string flowText(const Change& change) {
  return "{" + std::visit(ChangeFields{}, change) + "}";
}

std::string flowText(const std::vector<Change>& edit) {
  std::string text = "[";
  for (const Change& change : edit) {
    if (text.size() > 1) text += ", ";
    text += flowText(change);
  }
  return text + "]";
}

void checkStorable(const Tag& tag) {
  checkId(kindOf(tag), idOf(tag));
  std::visit(Check{tag}, tag);
}

void checkStorable(const Change& change) {
  if (const auto* put = std::get_if<PutTag>(&change)) checkStorable(put->tag);
  if (const auto* drop = std::get_if<DropTag>(&change)) checkId(drop->kind, drop->id);
  if (const auto* defer = std::get_if<DeferTag>(&change)) checkStorable(defer->pending.tag);
  if (const auto* reserve = std::get_if<ReserveIds>(&change)) checkIds(reserve->next_ids);
}

void checkStorable(const Knowledge& knowledge) {
  for (const AreaTag& tag : knowledge.areas) checkStorable(Tag(tag));
  for (const DoorTag& tag : knowledge.doors) checkStorable(Tag(tag));
  for (const ObjectTag& tag : knowledge.objects) checkStorable(Tag(tag));
  for (const PendingTag& pending : knowledge.pending) checkStorable(pending.tag);
  checkIds(knowledge.next_ids);
}

}  // namespace agrid
