// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/edit_decisions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "pipeline/edit_names.h"

namespace agrid {
namespace {

std::uint32_t nextId(const NextIds& next, TagKind kind) {
  return kind == TagKind::kArea ? next.area : kind == TagKind::kDoor ? next.door : next.object;
}

void setId(Tag& tag, std::uint32_t id) {
  std::visit([id](auto& t) { t.id = static_cast<decltype(t.id)>(id); }, tag);
}

void setName(Tag& tag, const std::string& name) {
  std::visit([&name](auto& t) { t.name = name; }, tag);
}

void setSource(Tag& tag, TagSource source) {
  std::visit([source](auto& t) { t.source = source; }, tag);
}

void requireRoom(const EditScope& scope, TagKind kind) {
  const Knowledge& known = scope.known();
  const std::size_t count =
      known.areas.size() + known.doors.size() + known.objects.size() + known.pending.size();
  if (count >= scope.params.max_tags) {
    refuse(EditErrorCode::kLimit, "there are " + std::to_string(count) + " tags, allowed are " +
                                      std::to_string(scope.params.max_tags));
  }
  if (nextId(known.next_ids, kind) == std::numeric_limits<std::uint32_t>::max()) {
    refuse(EditErrorCode::kLimit, "all ids have been given out");
  }
}

}  // namespace

void refuse(EditErrorCode code, const std::string& why) { throw EditError(code, why); }

std::string inWords(double length) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", length);
  return text;
}

std::string inWords(const Point2& point) {
  return "(" + inWords(point.x()) + ", " + inWords(point.y()) + ")";
}

std::optional<KnownTag> findKnown(const Knowledge& knowledge, TagKind kind, std::uint32_t id) {
  if (kind == TagKind::kArea) {
    if (const auto* tag = findTag(knowledge, AreaId{id})) return KnownTag{*tag};
  } else if (kind == TagKind::kDoor) {
    if (const auto* tag = findTag(knowledge, DoorId{id})) return KnownTag{*tag};
  } else {
    if (const auto* tag = findTag(knowledge, ObjectId{id})) return KnownTag{*tag};
  }
  for (const PendingTag& pending : knowledge.pending) {
    if (kindOf(pending.tag) == kind && idOf(pending.tag) == id) {
      return KnownTag{pending.tag, &pending};
    }
  }
  return std::nullopt;
}

Subject findSubject(const AddTag& request, const EditScope& scope) {
  const TagKind kind = kindOf(request.tag);
  if (const std::uint32_t id = idOf(request.tag)) {
    auto known = findKnown(scope.known(), kind, id);
    if (!known) refuse(EditErrorCode::kUnknownName, "there is no " + called(request.tag));
    return {std::move(known)};
  }
  if (request.placement == Placement::kUnchanged) {
    refuse(EditErrorCode::kInvalid, "a tag without an id needs a place");
  }
  if (nameOf(request.tag).empty()) return {};
  const auto id = idOfName(scope.map, kind, nameOf(request.tag));
  if (!id) return {};
  return {findKnown(scope.known(), kind, *id), true};
}

void requireFinite(const Point2& position, double yaw) {
  constexpr double kGreatest = 1e9;  // sums and products stay exact enough to mean something
  const auto is_fine = [](double value) { return std::abs(value) <= kGreatest; };  // not NaN
  if (is_fine(position.x()) && is_fine(position.y()) && is_fine(yaw)) return;
  refuse(EditErrorCode::kInvalid, "the pose must be finite and its numbers at most 1e9");
}

Pixel requireInside(const EditScope& scope, const Point2& point_map) {
  const MapGeometry& geometry = scope.geometry();
  if (const auto pixel = geometry.pixelAt(point_map)) return *pixel;
  const double right = geometry.width * geometry.resolution;
  const double top = geometry.height * geometry.resolution;
  std::string corners;
  for (const Point2& corner :
       {Point2(0, 0), Point2(right, 0), Point2(right, top), Point2(0, top)}) {
    corners += (corners.empty() ? "" : ", ") + inWords(geometry.map_from_image * corner);
  }
  refuse(EditErrorCode::kOutside,
         inWords(point_map) + " lies outside the map, whose corners are " + corners);
}

Properties merged(Properties known, const Properties& said) {
  for (const auto& [key, value] : said) {
    if (value.empty()) {
      known.erase(key);
    } else {
      known[key] = value;
    }
  }
  return known;
}

std::string newName(const std::string& name, const Properties& properties, const std::string& said,
                    bool by_name) {
  const bool stays = said.empty() || (by_name && isCalled(name, properties, said));
  return stays ? name : said;
}

Edit conclude(Decision decision, const std::optional<KnownTag>& known, TagSource source,
              const EditScope& scope) {
  Edit edit;
  edit.kind = kindOf(decision.tag);
  edit.id = idOf(decision.tag);
  const bool waited = known && known->pending;
  const bool waits = !decision.waits_because.empty();
  const bool becomes_given =
      known && sourceOf(known->tag) == TagSource::kAutomatic && source != TagSource::kAutomatic;
  if (known && waited == waits && decision.tag == known->tag && !becomes_given) {
    edit.message = called(decision.tag) + " is known so already";
    return edit;
  }
  if (edit.id == 0) {
    requireRoom(scope, edit.kind);
    edit.id = nextId(scope.known().next_ids, edit.kind);
    setId(decision.tag, edit.id);
  }
  if (nameOf(decision.tag).empty()) setName(decision.tag, defaultName(scope.map, decision.tag));
  setSource(decision.tag, source);
  requireUniqueNames(scope.map, decision.tag);
  requireTexts(decision.tag);
  edit.changes = std::move(decision.before);
  edit.message = called(decision.tag) + ": " + decision.message;
  if (waits) {
    const std::string frame = waited ? known->pending->frame_id : std::string();
    edit.changes.emplace_back(DeferTag{{decision.tag, frame, decision.waits_because}});
  } else {
    edit.changes.emplace_back(PutTag{decision.tag});
  }
  return edit;
}

}  // namespace agrid
