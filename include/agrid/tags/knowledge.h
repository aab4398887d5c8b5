// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "agrid/tags/tag.h"

namespace agrid {

/// The lowest ids that were never given out; an id is never used twice.
struct NextIds {
  std::uint32_t area = 1;
  std::uint32_t door = 1;
  std::uint32_t object = 1;
};

/// A given tag that has no sure place on the map; it waits, nothing of it is lost.
struct PendingTag {
  Tag tag;
  std::string frame_id;  ///< of its coordinates; empty: the same as of the tags that do not wait
  std::string reason;    ///< why it waits, a sentence for a person
};

/// All that is known about a place beyond its metric map: what people and robots said, and which
/// areas and doors were found there, so that they are known again. A value.
struct Knowledge {
  // each sorted by id, every id once and below the next one
  std::vector<AreaTag> areas;
  std::vector<DoorTag> doors;
  std::vector<ObjectTag> objects;
  std::vector<PendingTag> pending;  ///< sorted by kind, then id; ids that are not used above
  NextIds next_ids;
};

/// The kinds of tags, in the order of the variant `Tag`; the values are those of agrid_map/Tag.
enum class TagKind : std::uint8_t { kArea = 1, kDoor = 2, kObject = 3 };

TagKind kindOf(const Tag& tag);
std::uint32_t idOf(const Tag& tag);
const std::string& nameOf(const Tag& tag);
TagSource sourceOf(const Tag& tag);

/// From now on this tag holds, in place of any other of its kind and id, pending ones included.
struct PutTag {
  Tag tag;
};

/// Nothing of that kind and id is known any more.
struct DropTag {
  TagKind kind = TagKind::kArea;
  std::uint32_t id = 0;
};

/// The tag is kept, but waits for a sure place.
struct DeferTag {
  PendingTag pending;
};

/// Ids below these may have been given out.
struct ReserveIds {
  NextIds next_ids;
};

/// One step from what was known to what is known. Applying it twice is the same as once.
using Change = std::variant<PutTag, DropTag, DeferTag, ReserveIds>;

/// Ids at or beyond the next one move it past them; nothing lowers it.
void apply(const Change& change, Knowledge& knowledge);

/// What leads from one to the other: apply() all of it in order. Empty if they are equal, bit for
/// bit.
std::vector<Change> difference(const Knowledge& before, const Knowledge& after);

/// The tag of that kind and id among those that are not pending, or nullptr.
const AreaTag* findTag(const Knowledge& knowledge, AreaId id);
const DoorTag* findTag(const Knowledge& knowledge, DoorId id);
const ObjectTag* findTag(const Knowledge& knowledge, ObjectId id);

}  // namespace agrid
