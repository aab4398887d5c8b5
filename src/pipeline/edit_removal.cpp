// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <utility>

#include "areas/automatic_areas.h"
#include "areas/door_places.h"
#include "pipeline/edit_decisions.h"
#include "pipeline/edit_names.h"

namespace agrid {
namespace {

Edit drop(const KnownTag& known, const std::string& message) {
  Edit edit;
  edit.kind = kindOf(known.tag);
  edit.id = idOf(known.tag);
  edit.changes.emplace_back(DropTag{edit.kind, edit.id});
  edit.message = called(known.tag) + " " + message;
  return edit;
}

/// Whether an area is there only because someone said so.
bool isSeeded(AreaId id, const EditScope& scope) {
  const auto& groups = scope.map.groups;
  return std::any_of(groups.begin(), groups.end(), [id](const AreaGroup& group) {
    return group.members.empty() && std::count(group.areas.begin(), group.areas.end(), id) > 0;
  });
}

/// Whether geometry finds a door where this one is.
bool isFound(const DoorTag& door, const EditScope& scope) {
  if (door.source == TagSource::kAutomatic) return true;
  if (!scope.map.automatic) return false;
  const auto& found = scope.map.automatic->area_map.doors;
  return doorsMeant({&door}, found, scope.geometry().resolution).front().has_value();
}

/// What was said of an area is taken back; that there is one was found by geometry.
Edit takeBack(const AreaTag& known, const EditScope& scope) {
  if (known.source == TagSource::kAutomatic) {
    refuse(EditErrorCode::kUnknownName,
           "nobody said anything of " + called(known) + " that could be taken back");
  }
  if (isSeeded(known.id, scope)) return drop({known}, "is forgotten; no other area is there");
  AreaTag tag;
  tag.id = known.id;
  tag.name = defaultName(scope.map, tag);
  tag.seed_map = known.seed_map;
  tag.outline_map = known.outline_map;
  Edit edit;
  edit.kind = TagKind::kArea;
  edit.id = idOf(tag);
  edit.message = called(known) + " is called " + tag.name + " again";
  edit.changes.emplace_back(PutTag{std::move(tag)});
  return edit;
}

const Door* findDoor(const SemanticMap& map, DoorId id) {
  const auto& doors = map.area_map.doors;
  const auto door =
      std::find_if(doors.begin(), doors.end(), [&](const Door& d) { return d.id == id; });
  return door == doors.end() ? nullptr : &*door;
}

/// "; area 1 'kitchen' and area 2 'hall' become one ..."
std::string whatMerges(const Door& door, const EditScope& scope) {
  const AreaTag* a = findTag(scope.known(), std::min(door.areas[0], door.areas[1]));
  const AreaTag* b = findTag(scope.known(), std::max(door.areas[0], door.areas[1]));
  if (!a || !b || a == b) return {};
  const bool a_given = a->source != TagSource::kAutomatic;
  const bool b_given = b->source != TagSource::kAutomatic;
  const AreaTag* first = b_given && !a_given ? b : a;
  std::string text = "; " + called(*a) + " and " + called(*b) +
                     " become one, unless another door parts them: " + called(*first);
  if (a_given && b_given) text += ", and " + called(*b) + " waits";
  return text;
}

/// There is no door where one was found.
Edit makeAbsent(const DoorTag& known, const std::string& merged) {
  DoorTag tag;
  tag.id = known.id;
  tag.pose_map = known.pose_map;
  tag.width = known.width;
  tag.source = TagSource::kManual;
  tag.absent = true;
  Edit edit;
  edit.kind = TagKind::kDoor;
  edit.id = idOf(tag);
  edit.message = called(known) + " is no door any more" + merged;
  edit.changes.emplace_back(PutTag{std::move(tag)});
  return edit;
}

[[noreturn]] void refuseUnknown(TagKind kind, std::uint32_t id) {
  const char* name = kind == TagKind::kArea ? "area" : kind == TagKind::kDoor ? "door" : "object";
  refuse(EditErrorCode::kUnknownName,
         std::string("there is no ") + name + " " + std::to_string(id));
}

}  // namespace

Edit decideRemoval(const RemoveTag& request, const EditScope& scope) {
  const auto known = findKnown(scope.known(), request.kind, request.id);
  if (!known) refuseUnknown(request.kind, request.id);
  if (known->pending) return drop(*known, "is forgotten; it was waiting");
  if (request.kind == TagKind::kObject) return drop(*known, "is forgotten");
  if (request.kind == TagKind::kArea) return takeBack(std::get<AreaTag>(known->tag), scope);
  const auto& door = std::get<DoorTag>(known->tag);
  if (door.absent) refuseUnknown(request.kind, request.id);
  const Door* on_map = findDoor(scope.map, door.id);
  const std::string merged = on_map ? whatMerges(*on_map, scope) : std::string();
  if (!isFound(door, scope)) return drop(*known, "is forgotten" + merged);
  return makeAbsent(door, merged);
}

Edit decideState(const SetDoor& request, const EditScope& scope) {
  const auto id = static_cast<std::uint32_t>(request.door);
  const DoorTag* known = findTag(scope.known(), request.door);
  if (!known || known->absent) refuseUnknown(TagKind::kDoor, id);
  Edit edit;
  edit.kind = TagKind::kDoor;
  edit.id = id;
  const Door* door = findDoor(scope.map, request.door);
  const char* state = request.state == DoorState::kClosed ? "closed"
                      : request.state == DoorState::kOpen ? "open"
                                                          : "in an unknown state";
  edit.message = called(*known) + " is " + state;
  if (door && door->kind == DoorKind::kPassage && request.state == DoorState::kClosed) {
    edit.message += ", though it is a passage, " + inWords(door->width) + " m wide";
  }
  if (!door) edit.message += ", but it parts no areas";
  if (known->state == request.state) return edit;
  DoorTag tag = *known;
  tag.state = request.state;
  tag.source = request.source == TagSource::kAutomatic ? TagSource::kManual : request.source;
  edit.changes.emplace_back(PutTag{std::move(tag)});
  return edit;
}

}  // namespace agrid
