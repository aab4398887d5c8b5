// SPDX-License-Identifier: BSD-3-Clause
#include "storage/tag_reading.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include "agrid/storage.h"
#include "map/printable.h"
#include "storage/flow_text.h"
#include "storage/tag_text.h"

namespace agrid {
namespace {

using Kind = StoredNode::Kind;

constexpr std::uint64_t kMaxId = std::numeric_limits<std::uint32_t>::max() - 1;
constexpr std::size_t kMaxWarnings = 20;

std::string found(const StoredNode& node) {
  if (node.kind == Kind::kScalar) return "'" + printable(node.text.substr(0, 64)) + "'";
  if (node.kind == Kind::kNull) return "nothing";
  return node.kind == Kind::kSequence ? "a list" : "a mapping";
}

/// Gives out the values of a mapping by key and knows which ones nobody asked for.
class Fields {
 public:
  Fields(const StoredNode& node, StoredText& text) : node_(node), text_(text) {
    if (node.kind != Kind::kMapping) refuseNode(text, node, "must be a mapping of keys to values");
  }

  const StoredNode* find(std::string_view key) {
    asked_.push_back(key);
    const auto child = std::find_if(node_.children.begin(), node_.children.end(),
                                    [key](const StoredNode& c) { return c.key == key; });
    return child == node_.children.end() || child->kind == Kind::kNull ? nullptr : &*child;
  }

  const StoredNode& required(std::string_view key) {
    const StoredNode* child = find(key);
    if (child == nullptr) refuseNode(text_, node_, "key '" + std::string(key) + "' is missing");
    return *child;
  }

  std::string text(std::string_view key) {
    const StoredNode* child = find(key);
    return child == nullptr ? std::string() : readText(*child, text_);
  }

  std::uint32_t id() {
    const StoredNode* child = find("id");
    return child == nullptr ? 0 : static_cast<std::uint32_t>(readWhole(*child, 1, kMaxId, text_));
  }

  double length(std::string_view key) {
    const StoredNode* child = find(key);
    return child == nullptr ? 0 : lengthOf(*child);
  }

  double lengthOf(const StoredNode& node) {
    const double length = number(node);
    if (length < 0) refuseNode(text_, node, "must not be negative, is " + found(node));
    return length;
  }

  double number(const StoredNode& node) {
    const auto number = node.kind == Kind::kScalar ? numberOf(node.text) : std::nullopt;
    if (!number) refuseNode(text_, node, "must be a number, is " + found(node));
    return *number;
  }

  Point2 point(const StoredNode& node) {
    expectList(node, 2, 2, "[x, y]");
    return {number(node.children[0]), number(node.children[1])};
  }

  Pose2 pose(const StoredNode& node) {
    expectList(node, 2, 3, "[x, y, yaw]");
    const Point2 position(number(node.children[0]), number(node.children[1]));
    return {position, node.children.size() > 2 ? number(node.children[2]) : 0};
  }

  Point2 size(std::string_view key) {
    const StoredNode* child = find(key);
    if (child == nullptr) return Point2::Zero();
    expectList(*child, 2, 2, "[along x, along y]");
    return {lengthOf(child->children[0]), lengthOf(child->children[1])};
  }

  Polygon polygon(std::string_view key) {
    Polygon corners;
    const StoredNode* child = find(key);
    if (child == nullptr) return corners;
    expectList(*child, 0, std::numeric_limits<std::size_t>::max(), "[[x, y], ...]");
    for (const StoredNode& corner : child->children) corners.push_back(point(corner));
    return corners;
  }

  Properties properties() {
    Properties properties;
    const StoredNode* child = find("properties");
    if (child == nullptr) return properties;
    if (child->kind != Kind::kMapping) refuseNode(text_, *child, "must be a mapping of texts");
    for (const StoredNode& entry : child->children) properties[entry.key] = readText(entry, text_);
    return properties;
  }

  template <typename Enumerator>
  Enumerator word(std::string_view key, const std::array<std::string_view, 3>& words,
                  Enumerator otherwise) {
    const StoredNode* child = find(key);
    return child == nullptr ? otherwise : static_cast<Enumerator>(wordIndex(*child, words));
  }

  std::size_t wordIndex(const StoredNode& node, const std::array<std::string_view, 3>& words) {
    const auto* word = std::find(words.begin(), words.end(), node.text);
    if (node.kind != Kind::kScalar || word == words.end()) {
      refuseNode(text_, node,
                 "must be " + std::string(words[0]) + ", " + std::string(words[1]) + " or " +
                     std::string(words[2]) + ", is " + found(node));
    }
    return static_cast<std::size_t>(word - words.begin());
  }

  TagKind kind(const StoredNode& node) {
    return static_cast<TagKind>(wordIndex(node, kKindWords) + 1);
  }

  bool truth(std::string_view key) {
    const StoredNode* child = find(key);
    if (child == nullptr || child->text == "false") return false;
    if (child->text != "true") {
      refuseNode(text_, *child, "must be true or false, is " + found(*child));
    }
    return true;
  }

  void warnOfUnknown() {
    for (const StoredNode& child : node_.children) {
      if (std::find(asked_.begin(), asked_.end(), child.key) != asked_.end()) continue;
      if (text_.warnings.size() >= kMaxWarnings) return;
      text_.warnings.push_back(text_.name + ":" + std::to_string(child.line) + ": unknown key '" +
                               printable(child.key.substr(0, 64)) + "' left out");
    }
  }

 private:
  void expectList(const StoredNode& node, std::size_t least, std::size_t most, const char* form) {
    const std::size_t size = node.children.size();
    if (node.kind == Kind::kSequence && size >= least && size <= most) return;
    const std::string count = node.kind == Kind::kSequence ? " of " + std::to_string(size) : "";
    refuseNode(text_, node, "must be " + std::string(form) + ", is " + found(node) + count);
  }

  const StoredNode& node_;
  StoredText& text_;
  std::vector<std::string_view> asked_;
};

AreaTag readArea(Fields& fields) {
  AreaTag tag;
  tag.id = AreaId{fields.id()};
  tag.name = fields.text("name");
  tag.category = fields.text("category");
  tag.seed_map = fields.point(fields.required("seed"));
  tag.source = fields.word("source", kSourceWords, TagSource::kManual);
  tag.properties = fields.properties();
  tag.outline_map = fields.polygon("outline");
  return tag;
}

DoorTag readDoor(Fields& fields) {
  DoorTag tag;
  tag.id = DoorId{fields.id()};
  tag.name = fields.text("name");
  tag.pose_map = fields.pose(fields.required("pose"));
  tag.width = fields.length("width");
  tag.state = fields.word("state", kStateWords, DoorState::kUnknown);
  tag.source = fields.word("source", kSourceWords, TagSource::kManual);
  tag.properties = fields.properties();
  tag.absent = fields.truth("absent");
  return tag;
}

ObjectTag readObject(Fields& fields) {
  ObjectTag tag;
  tag.id = ObjectId{fields.id()};
  tag.name = fields.text("name");
  tag.category = fields.text("category");
  tag.pose_map = fields.pose(fields.required("pose"));
  tag.size = fields.size("size");
  tag.height = fields.length("height");
  tag.source = fields.word("source", kSourceWords, TagSource::kManual);
  tag.properties = fields.properties();
  return tag;
}

Tag readTag(TagKind kind, Fields& fields) {
  if (kind == TagKind::kArea) return readArea(fields);
  if (kind == TagKind::kDoor) return readDoor(fields);
  return readObject(fields);
}

PendingTag readPending(TagKind kind, Fields& fields) {
  PendingTag pending;
  pending.frame_id = fields.text("frame_id");
  pending.reason = fields.text("reason");
  pending.tag = readTag(kind, fields);
  return pending;
}

Change readChange(const StoredNode& node, StoredText& text) {
  Fields fields(node, text);
  if (const StoredNode* put = fields.find("put")) return PutTag{readTag(fields.kind(*put), fields)};
  if (const StoredNode* defer = fields.find("defer")) {
    return DeferTag{readPending(fields.kind(*defer), fields)};
  }
  if (const StoredNode* reserve = fields.find("reserve")) {
    return ReserveIds{readNextIds(*reserve, text)};
  }
  return DropTag{fields.kind(fields.required("drop")), fields.id()};
}

}  // namespace

void refuseNode(const StoredText& text, const StoredNode& node, const std::string& what) {
  const std::string key = node.key.empty() ? "" : printable(node.key.substr(0, 64)) + " ";
  throw StorageError(StorageErrorCode::kCorrupt,
                     text.name + ":" + std::to_string(node.line) + ": " + key + what);
}

const std::string& readText(const StoredNode& node, const StoredText& text) {
  if (node.kind == Kind::kSequence || node.kind == Kind::kMapping) {
    refuseNode(text, node, "must be a text, is " + found(node));
  }
  return node.text;
}

std::uint64_t readWhole(const StoredNode& node, std::uint64_t least, std::uint64_t most,
                        const StoredText& text) {
  std::uint64_t value = 0;
  const char* end = node.text.data() + node.text.size();
  const auto read = std::from_chars(node.text.data(), end, value);
  if (node.kind != Kind::kScalar || read.ec != std::errc() || read.ptr != end || value < least ||
      value > most) {
    refuseNode(text, node,
               "must be a whole number in [" + std::to_string(least) + ", " + std::to_string(most) +
                   "], is " + found(node));
  }
  return value;
}

Tag readTag(TagKind kind, const StoredNode& node, StoredText& text) {
  Fields fields(node, text);
  Tag tag = readTag(kind, fields);
  fields.warnOfUnknown();
  return tag;
}

PendingTag readPending(const StoredNode& node, StoredText& text) {
  Fields fields(node, text);
  PendingTag pending = readPending(fields.kind(fields.required("kind")), fields);
  fields.warnOfUnknown();
  return pending;
}

NextIds readNextIds(const StoredNode& node, StoredText& text) {
  Fields fields(node, text);
  const auto id = [&](const char* key) {
    const StoredNode* child = fields.find(key);
    return child == nullptr ? 1U
                            : static_cast<std::uint32_t>(readWhole(*child, 1, kMaxId + 1, text));
  };
  NextIds ids;
  ids.area = id("area");
  ids.door = id("door");
  ids.object = id("object");
  fields.warnOfUnknown();
  return ids;
}

std::vector<Change> readEdit(const StoredNode& node, StoredText& text) {
  if (node.kind != Kind::kSequence) refuseNode(text, node, "must be a list of changes");
  std::vector<Change> edit;
  for (const StoredNode& child : node.children) edit.push_back(readChange(child, text));
  return edit;
}

}  // namespace agrid
