// SPDX-License-Identifier: BSD-3-Clause
#include "storage/snapshot.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "map/printable.h"
#include "storage/checksum.h"
#include "storage/flow_text.h"
#include "storage/tag_reading.h"
#include "storage/tag_text.h"
#include "storage/yaml_document.h"

namespace agrid {
namespace {

constexpr int kFormatVersion = 1;
constexpr std::string_view kVersionKey = "format_version: ";
constexpr std::string_view kChecksumKey = "checksum: ";

constexpr const char* kHeader =
    "# What is known of a place beyond its metric map: areas, doors and objects "
    "(doc/file_format.md\n"
    "# of agrid_map). May be edited while nothing uses it. Coordinates are in frame_id, lengths "
    "in\n"
    "# metres, angles in radians counter-clockwise from x. Of a new tag, id may be left out, and "
    "so\n"
    "# may all but seed and pose; history and sequence must stay; checksum may go.\n"
    "#   areas    seed: [x, y] of a point in it; category; source: manual, interaction, "
    "automatic;\n"
    "#            outline: [[x, y], ...] where it was last seen; properties: {key: text}\n"
    "#   doors    pose: [x, y, yaw] of its centre, x leads through it; width (0: up to the "
    "walls);\n"
    "#            state: unknown, open, closed; absent: true says that there is no door\n"
    "#   objects  pose: [x, y, yaw]; size: [along x, along y] of its own axes; height\n"
    "#   pending  tags that wait for a sure place: kind, reason, and frame_id of their "
    "coordinates\n";

template <typename Items>
void addList(const char* key, const Items& items, std::string& text) {
  text += key;
  text += items.empty() ? ": []\n" : ":\n";
  for (const auto& item : items) text += "  - " + flowText(item) + "\n";
}

std::vector<Tag> asTags(const Knowledge& knowledge, TagKind kind) {
  if (kind == TagKind::kArea) return {knowledge.areas.begin(), knowledge.areas.end()};
  if (kind == TagKind::kDoor) return {knowledge.doors.begin(), knowledge.doors.end()};
  return {knowledge.objects.begin(), knowledge.objects.end()};
}

/// Puts the entries of a file together.
class SnapshotReader {
 public:
  explicit SnapshotReader(const std::string& path) { text_.name = path; }

  void take(const std::string& section, StoredNode&& node) {
    if (section == "areas") return addTag(TagKind::kArea, node, areas_);
    if (section == "doors") return addTag(TagKind::kDoor, node, doors_);
    if (section == "objects") return addTag(TagKind::kObject, node, objects_);
    if (section == "pending") {
      pending_.push_back(readPending(node, text_));
      return note(pending_.back().tag, node);
    }
    if (section.empty()) {
      takeEntry(node);
    } else {
      warnOfUnknown(section, node.line);
    }
  }

  ReadSnapshot finish() {
    StoredNode place;
    place.line = last_line_;
    if (!has_version_) refuseNode(text_, place, "key 'format_version' is missing");
    if (!has_end_) refuseNode(text_, place, "ends without 'end_of_file: true'; cut short?");
    Knowledge& known = result_.snapshot.map.knowledge;
    keepNextIdsBeyond();
    known.areas = numbered(std::move(areas_), known.next_ids.area);
    known.doors = numbered(std::move(doors_), known.next_ids.door);
    known.objects = numbered(std::move(objects_), known.next_ids.object);
    known.pending = numberedPending(known.next_ids);
    result_.warnings = std::move(text_.warnings);
    return std::move(result_);
  }

 private:
  template <typename T>
  void addTag(TagKind kind, const StoredNode& node, std::vector<T>& tags) {
    const Tag tag = readTag(kind, node, text_);
    note(tag, node);
    tags.push_back(std::get<T>(tag));
  }

  void note(const Tag& tag, const StoredNode& node) {
    last_line_ = node.line;
    const std::uint32_t id = idOf(tag);
    if (id == 0) return;
    std::uint32_t& highest = highest_[tag.index()];
    highest = std::max(highest, id);
    const auto [entry, is_new] = lines_[tag.index()].emplace(id, node.line);
    if (is_new) return;
    refuseNode(text_, node,
               std::string(wordOf(kindOf(tag))) + " id " + std::to_string(id) +
                   " is there twice, first in line " + std::to_string(entry->second));
  }

  void takeEntry(const StoredNode& node) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 2;
    Snapshot& snapshot = result_.snapshot;
    last_line_ = node.line;
    if (node.key == "format_version") {
      has_version_ = readWhole(node, kFormatVersion, kFormatVersion, text_) == kFormatVersion;
    } else if (node.key == "map_id") {
      snapshot.map.map_id = readText(node, text_);
    } else if (node.key == "frame_id") {
      snapshot.map.frame_id = readText(node, text_);
    } else if (node.key == "history") {
      snapshot.history = readHistory(node);
    } else if (node.key == "sequence") {
      snapshot.sequence = readWhole(node, 0, kMost, text_);
    } else if (node.key == "next_ids") {
      snapshot.map.knowledge.next_ids = readNextIds(node, text_);
    } else if (node.key == "end_of_file") {
      if (readText(node, text_) != "true") refuseNode(text_, node, "must be true");
      has_end_ = true;
    } else if (isList(node.key)) {
      if (node.kind != StoredNode::Kind::kNull) refuseNode(text_, node, "must be a list");
    } else if (node.key != "checksum") {
      warnOfUnknown(node.key, node.line);
    }
  }

  static bool isList(const std::string& key) {
    return key == "areas" || key == "doors" || key == "objects" || key == "pending";
  }

  std::uint64_t readHistory(const StoredNode& node) const {
    const auto history = valueOfHexadecimal(readText(node, text_));
    if (!history) refuseNode(text_, node, "must be 16 hexadecimal digits");
    return *history;
  }

  void warnOfUnknown(const std::string& key, int line) {
    const std::string warning = "unknown key '" + printable(key.substr(0, 64)) + "' left out";
    if (key == warned_key_) return;
    warned_key_ = key;
    text_.warnings.push_back(text_.name + ":" + std::to_string(line) + ": " + warning);
  }

  void keepNextIdsBeyond() {
    NextIds& next = result_.snapshot.map.knowledge.next_ids;
    next.area = std::max(next.area, highest_[0] + 1);
    next.door = std::max(next.door, highest_[1] + 1);
    next.object = std::max(next.object, highest_[2] + 1);
  }

  template <typename Id>
  void giveId(Id& id, std::uint32_t& next) const {
    if (id != Id{}) return;
    if (next == std::numeric_limits<std::uint32_t>::max()) {
      throw StorageError(StorageErrorCode::kCorrupt, text_.name + ": no id is left for a new tag");
    }
    id = Id{next++};
  }

  template <typename T>
  std::vector<T> numbered(std::vector<T> tags, std::uint32_t& next) const {
    for (T& tag : tags) giveId(tag.id, next);
    std::sort(tags.begin(), tags.end(), [](const T& a, const T& b) { return a.id < b.id; });
    return tags;
  }

  std::vector<PendingTag> numberedPending(NextIds& next) {
    for (PendingTag& pending : pending_) {
      if (auto* area = std::get_if<AreaTag>(&pending.tag)) giveId(area->id, next.area);
      if (auto* door = std::get_if<DoorTag>(&pending.tag)) giveId(door->id, next.door);
      if (auto* object = std::get_if<ObjectTag>(&pending.tag)) giveId(object->id, next.object);
    }
    std::sort(pending_.begin(), pending_.end(), [](const PendingTag& a, const PendingTag& b) {
      return std::make_pair(kindOf(a.tag), idOf(a.tag)) <
             std::make_pair(kindOf(b.tag), idOf(b.tag));
    });
    return std::move(pending_);
  }

  StoredText text_;
  ReadSnapshot result_;
  std::vector<AreaTag> areas_;
  std::vector<DoorTag> doors_;
  std::vector<ObjectTag> objects_;
  std::vector<PendingTag> pending_;
  std::array<std::unordered_map<std::uint32_t, int>, 3> lines_;  // of the ids of a kind
  std::array<std::uint32_t, 3> highest_{};
  std::string warned_key_;
  int last_line_ = 1;
  bool has_version_ = false;
  bool has_end_ = false;
};

// Looked for in the text, since nothing else of a newer version needs to be understood.
void refuseNewerVersion(const std::string& text, const std::string& path) {
  const std::size_t place = text.find("\n" + std::string(kVersionKey));
  if (place == std::string::npos) return;
  const char* digits = text.data() + place + 1 + kVersionKey.size();
  std::uint64_t version = 0;
  const auto read = std::from_chars(digits, text.data() + text.size(), version);
  if (read.ec != std::errc() || version <= kFormatVersion) return;
  throw StorageError(StorageErrorCode::kVersion,
                     path + ": format_version " + std::to_string(version) +
                         " is newer than what can be read, " + std::to_string(kFormatVersion));
}

enum class Checksum { kRight, kWrong, kMissing };

Checksum judge(const std::string& text, const std::string& path) {
  const std::size_t line_end = text.rfind("\n" + std::string(kChecksumKey));
  if (line_end == std::string::npos) return Checksum::kMissing;
  const std::string_view content = std::string_view(text).substr(0, line_end + 1);
  std::string_view stored = std::string_view(text).substr(line_end + 1 + kChecksumKey.size());
  if (stored.size() != 19 || stored.front() != '"') return Checksum::kWrong;
  const auto value = valueOfHexadecimal(stored.substr(1, 16));
  if (!value) return Checksum::kWrong;
  if (checksumOf(content) == *value) return Checksum::kRight;
  if (const auto place = flippedByte(content, *value)) {
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*place), '\n');
    throw StorageError(
        StorageErrorCode::kCorrupt,
        path + ":" + std::to_string(line + 1) +
            ": a bit was flipped (if this is a change by hand, delete the checksum)");
  }
  return Checksum::kWrong;
}

}  // namespace

std::string snapshotText(const Snapshot& snapshot) {
  const Knowledge& known = snapshot.map.knowledge;
  std::string text = kHeader;
  text += std::string(kVersionKey) + std::to_string(kFormatVersion) + "\n";
  text += "map_id: " + quoted(snapshot.map.map_id) + "\n";
  text += "frame_id: " + quoted(snapshot.map.frame_id) + "\n";
  text += "history: \"" + hexadecimalOf(snapshot.history) + "\"\n";
  text += "sequence: " + std::to_string(snapshot.sequence) + "\n";
  text += "next_ids: " + flowText(known.next_ids) + "\n";
  addList("areas", asTags(known, TagKind::kArea), text);
  addList("doors", asTags(known, TagKind::kDoor), text);
  addList("objects", asTags(known, TagKind::kObject), text);
  addList("pending", known.pending, text);
  text += "end_of_file: true\n";
  return text + std::string(kChecksumKey) + quoted(hexadecimalOf(checksumOf(text))) + "\n";
}

namespace {

ReadSnapshot readEntries(const std::string& text, const std::string& path) {
  SnapshotReader reader(path);
  if (readOwnYaml(text, [&](const std::string& section, StoredNode&& node) {
        reader.take(section, std::move(node));
      })) {
    return reader.finish();
  }
  SnapshotReader slow_reader(path);
  readYaml(text, path, [&](const std::string& section, StoredNode&& node) {
    slow_reader.take(section, std::move(node));
  });
  return slow_reader.finish();
}

}  // namespace

ReadSnapshot readSnapshot(const std::string& text, const std::string& path) {
  refuseNewerVersion(text, path);
  const Checksum checksum = judge(text, path);
  const std::size_t zero = text.find('\0');  // blocks that never reached the disk; no editor's work
  if (checksum != Checksum::kRight && zero != std::string::npos) {
    throw StorageError(StorageErrorCode::kCorrupt,
                       path + ": a zero byte at " + std::to_string(zero));
  }
  ReadSnapshot read = readEntries(text, path);
  if (checksum != Checksum::kRight) {
    read.warnings.insert(read.warnings.begin(), path + ": changed by hand since it was saved");
  }
  return read;
}

}  // namespace agrid
