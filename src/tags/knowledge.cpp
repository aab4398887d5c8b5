// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/knowledge.h"

#include <algorithm>
#include <tuple>

namespace agrid {
namespace {

template <typename T>
std::uint32_t number(const T& tag) {
  return static_cast<std::uint32_t>(tag.id);
}

template <typename Tags>
auto placeOf(Tags& tags, std::uint32_t id) {
  return std::lower_bound(tags.begin(), tags.end(), id,
                          [](const auto& tag, std::uint32_t i) { return number(tag) < i; });
}

template <typename Tags>
auto* findIn(Tags& tags, std::uint32_t id) {
  const auto place = placeOf(tags, id);
  return place == tags.end() || number(*place) != id ? nullptr : &*place;
}

template <typename T>
void putIn(std::vector<T>& tags, const T& tag) {
  const auto place = placeOf(tags, number(tag));
  if (place != tags.end() && place->id == tag.id) {
    *place = tag;
  } else {
    tags.insert(place, tag);
  }
}

template <typename T>
void dropFrom(std::vector<T>& tags, std::uint32_t id) {
  const auto place = placeOf(tags, id);
  if (place != tags.end() && number(*place) == id) tags.erase(place);
}

std::vector<AreaTag>& listOf(Knowledge& k, const AreaTag&) { return k.areas; }
std::vector<DoorTag>& listOf(Knowledge& k, const DoorTag&) { return k.doors; }
std::vector<ObjectTag>& listOf(Knowledge& k, const ObjectTag&) { return k.objects; }

std::uint32_t& nextOf(NextIds& next, TagKind kind) {
  return kind == TagKind::kArea ? next.area : kind == TagKind::kDoor ? next.door : next.object;
}

std::pair<TagKind, std::uint32_t> keyOf(const PendingTag& pending) {
  return {kindOf(pending.tag), idOf(pending.tag)};
}

auto placeOf(std::vector<PendingTag>& pending, TagKind kind, std::uint32_t id) {
  return std::lower_bound(pending.begin(), pending.end(), std::make_pair(kind, id),
                          [](const PendingTag& p, const auto& key) { return keyOf(p) < key; });
}

void dropPending(TagKind kind, std::uint32_t id, std::vector<PendingTag>& pending) {
  const auto place = placeOf(pending, kind, id);
  if (place != pending.end() && keyOf(*place) == std::make_pair(kind, id)) pending.erase(place);
}

void drop(TagKind kind, std::uint32_t id, Knowledge& knowledge) {
  if (kind == TagKind::kArea) dropFrom(knowledge.areas, id);
  if (kind == TagKind::kDoor) dropFrom(knowledge.doors, id);
  if (kind == TagKind::kObject) dropFrom(knowledge.objects, id);
  dropPending(kind, id, knowledge.pending);
}

void reserve(const NextIds& ids, NextIds& next) {
  next.area = std::max(next.area, ids.area);
  next.door = std::max(next.door, ids.door);
  next.object = std::max(next.object, ids.object);
}

void reserveBeyond(const Tag& tag, NextIds& next) {
  std::uint32_t& id = nextOf(next, kindOf(tag));
  id = std::max(id, idOf(tag) + 1);
}

bool same(const PendingTag& a, const PendingTag& b) {
  return a.tag == b.tag && a.frame_id == b.frame_id && a.reason == b.reason;
}

/// Adds what leads from one sorted list of tags to another.
template <typename T>
void addDifference(const std::vector<T>& before, const std::vector<T>& after,
                   std::vector<Change>& drops, std::vector<Change>& puts) {
  auto old = before.begin();
  for (const T& tag : after) {
    for (; old != before.end() && old->id < tag.id; ++old) {
      drops.emplace_back(DropTag{kindOf(Tag(tag)), number(*old)});
    }
    const bool known = old != before.end() && old->id == tag.id;
    if (!known || !(*old == tag)) puts.emplace_back(PutTag{tag});
    if (known) ++old;
  }
  for (; old != before.end(); ++old) drops.emplace_back(DropTag{kindOf(Tag(*old)), number(*old)});
}

void addDifference(const std::vector<PendingTag>& before, const std::vector<PendingTag>& after,
                   std::vector<Change>& drops, std::vector<Change>& puts) {
  auto old = before.begin();
  for (const PendingTag& pending : after) {
    for (; old != before.end() && keyOf(*old) < keyOf(pending); ++old) {
      drops.emplace_back(DropTag{kindOf(old->tag), idOf(old->tag)});
    }
    const bool known = old != before.end() && keyOf(*old) == keyOf(pending);
    if (!known || !same(*old, pending)) puts.emplace_back(DeferTag{pending});
    if (known) ++old;
  }
  for (; old != before.end(); ++old) drops.emplace_back(DropTag{kindOf(old->tag), idOf(old->tag)});
}

struct Applier {
  Knowledge& knowledge;

  void operator()(const PutTag& put) const {
    dropPending(kindOf(put.tag), idOf(put.tag), knowledge.pending);
    std::visit([this](const auto& tag) { putIn(listOf(knowledge, tag), tag); }, put.tag);
    reserveBeyond(put.tag, knowledge.next_ids);
  }
  void operator()(const DropTag& gone) const { drop(gone.kind, gone.id, knowledge); }
  void operator()(const DeferTag& defer) const {
    const auto [kind, id] = keyOf(defer.pending);
    drop(kind, id, knowledge);
    knowledge.pending.insert(placeOf(knowledge.pending, kind, id), defer.pending);
    reserveBeyond(defer.pending.tag, knowledge.next_ids);
  }
  void operator()(const ReserveIds& ids) const { reserve(ids.next_ids, knowledge.next_ids); }
};

}  // namespace

TagKind kindOf(const Tag& tag) { return static_cast<TagKind>(tag.index() + 1); }

std::uint32_t idOf(const Tag& tag) {
  return std::visit([](const auto& t) { return number(t); }, tag);
}

const std::string& nameOf(const Tag& tag) {
  return std::visit([](const auto& t) -> const std::string& { return t.name; }, tag);
}

TagSource sourceOf(const Tag& tag) {
  return std::visit([](const auto& t) { return t.source; }, tag);
}

void apply(const Change& change, Knowledge& knowledge) { std::visit(Applier{knowledge}, change); }

std::vector<Change> difference(const Knowledge& before, const Knowledge& after) {
  std::vector<Change> drops;  // first: a tag that moves between the lists is dropped from one
  std::vector<Change> puts;
  addDifference(before.areas, after.areas, drops, puts);
  addDifference(before.doors, after.doors, drops, puts);
  addDifference(before.objects, after.objects, drops, puts);
  addDifference(before.pending, after.pending, drops, puts);
  const auto ids = [](const NextIds& n) { return std::tie(n.area, n.door, n.object); };
  if (ids(before.next_ids) != ids(after.next_ids)) puts.emplace_back(ReserveIds{after.next_ids});
  for (Change& put : puts) drops.push_back(std::move(put));
  return drops;
}

const AreaTag* findTag(const Knowledge& knowledge, AreaId id) {
  return findIn(knowledge.areas, static_cast<std::uint32_t>(id));
}

const DoorTag* findTag(const Knowledge& knowledge, DoorId id) {
  return findIn(knowledge.doors, static_cast<std::uint32_t>(id));
}

const ObjectTag* findTag(const Knowledge& knowledge, ObjectId id) {
  return findIn(knowledge.objects, static_cast<std::uint32_t>(id));
}

}  // namespace agrid
