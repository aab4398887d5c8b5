// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "pipeline/edit_decisions.h"
#include "pipeline/edit_names.h"
#include "pipeline/narrow_place.h"

namespace agrid {
namespace {

constexpr double kHeadStart = 0.3;     // a known door is meant rather than a place [m of cost]
constexpr double kWidestCost = 1.5;    // wide borders are meant as well [m]
constexpr double kSameDoor = 0.15;     // forced so near to a door a tag names it [m]
constexpr double kUsualDoor = 0.9;     // where nobody says how wide a door is [m]
constexpr double kWidestPlace = 10;    // wider places are not looked for [m]
constexpr double kLargestClutter = 5;  // larger obstacles are jambs; bounds what is looked at [m]
constexpr double kFartherReach = 3;    // how far a refusal looks for a passage to name [m]

/// Where a door is to lie.
struct DoorPlace {
  Pose2 pose_map;
  double width = 0;
  const DoorTag* known = nullptr;  ///< the door that is meant; none: there is none yet
  std::string message;
};

void requireWidth(double width, const EditScope& scope) {
  const double diagonal =
      std::hypot(scope.geometry().width, scope.geometry().height) * scope.geometry().resolution;
  if (width >= 0 && width <= diagonal) return;  // not NaN
  refuse(EditErrorCode::kInvalid,
         "a door's width must lie in [0, " + inWords(diagonal) + "] m; 0: up to the walls");
}

/// A door that is known, as far as it tells whether it is meant.
struct KnownDoor {
  const DoorTag* tag = nullptr;
  double distance = 0;  ///< from the point asked for to the line between its jambs [m]
  double cost = 0;      ///< see costOfPlace
};

double widthOf(const DoorTag& tag, const EditScope& scope) {
  if (tag.width > 0) return tag.width;
  const auto& doors = scope.map.area_map.doors;
  const auto door =
      std::find_if(doors.begin(), doors.end(), [&](const Door& d) { return d.id == tag.id; });
  return door == doors.end() ? kUsualDoor : door->width;
}

KnownDoor asSeenFrom(const Point2& point, const DoorTag& tag, const EditScope& scope) {
  const double width = widthOf(tag, scope);
  const Point2 across(-std::sin(tag.pose_map.yaw), std::cos(tag.pose_map.yaw));
  const Point2 offset = point - tag.pose_map.position;
  const double along = std::clamp(offset.dot(across), -width / 2, width / 2);
  const double distance = (offset - across * along).norm();
  return {&tag, distance, costOfPlace(std::min(width, kWidestCost), distance) - kHeadStart};
}

std::optional<double> headingOf(const AddTag& request, const DoorTag& said) {
  if (request.placement == Placement::kAnyHeading) return std::nullopt;
  return said.pose_map.yaw;
}

/// The known door, absent ones included, that costs least to be the one that is meant.
std::optional<KnownDoor> findKnownDoor(const AddTag& request, const DoorTag& said,
                                       const EditScope& scope) {
  const Point2& point = said.pose_map.position;
  const auto yaw = headingOf(request, said);
  std::optional<KnownDoor> best;
  for (const DoorTag& tag : scope.known().doors) {
    const double half = (tag.width > 0 ? tag.width : kWidestPlace) / 2;
    const Point2 offset = tag.pose_map.position - point;
    if (offset.cwiseAbs().maxCoeff() > scope.params.door_snap_dist + half) continue;
    if (yaw && std::abs(std::cos(tag.pose_map.yaw - *yaw)) < std::sqrt(0.5) - 1e-9) continue;
    const KnownDoor door = asSeenFrom(point, tag, scope);
    if (door.distance > scope.params.door_snap_dist || (best && door.cost >= best->cost)) continue;
    best = door;
  }
  return best;
}

NarrowPlaceQuery queryFor(const AddTag& request, const DoorTag& said, const EditScope& scope) {
  NarrowPlaceQuery query;
  query.near_map = said.pose_map.position;
  query.yaw = headingOf(request, said);
  query.reach = scope.params.door_snap_dist;
  query.max_width = std::min(kWidestPlace, std::max(scope.params.max_door_width, said.width * 1.2));
  query.max_clutter_diagonal = std::min(kLargestClutter, scope.params.max_clutter_diagonal);
  return query;
}

[[noreturn]] void refuseFar(NarrowPlaceQuery query, const EditScope& scope) {
  std::string why = "there is no passage up to " + inWords(query.max_width) + " m wide within " +
                    inWords(query.reach) + " m of " + inWords(query.near_map);
  query.reach = std::max(kFartherReach, 2 * query.reach);
  if (const auto place = findNarrowPlace(scope.map.map(), query)) {
    why += "; the nearest is " + inWords(place->distance) + " m away at " +
           inWords(place->pose_map.position);
  } else {
    why += ", nor within " + inWords(query.reach) + " m";
  }
  refuse(EditErrorCode::kInvalid, why + "; force keeps the door where it was given");
}

/// Another door is the same if it is as near as what the areas are laid out with takes for it.
bool isSameDoor(const DoorTag& door, const DoorTag& said, const EditScope& scope) {
  const double reach = std::max(kSameDoor, 2 * scope.geometry().resolution);
  return (door.pose_map.position - said.pose_map.position).norm() <= reach &&
         std::abs(std::cos(door.pose_map.yaw - said.pose_map.yaw)) > std::sqrt(0.5);
}

/// Where a door is forced to be: on one that is there, or as it was given.
DoorPlace asGiven(const AddTag& request, const DoorTag& said, const Subject& subject,
                  const EditScope& scope) {
  const bool moves = said.id != DoorId{0} || request.replace;
  const DoorTag* self =
      subject.known ? findTag(scope.known(), DoorId{idOf(subject.known->tag)}) : nullptr;
  for (const DoorTag& door : scope.known().doors) {
    if ((moves && &door == self) || !isSameDoor(door, said, scope)) continue;
    if (moves) return {said.pose_map, said.width, &door, "as given"};
    return {door.pose_map, said.width > 0 ? said.width : door.width, &door, "as given"};
  }
  return {said.pose_map, said.width, moves ? self : nullptr, "as given"};
}

/// The door or the passage that is meant.
DoorPlace findPlace(const AddTag& request, const DoorTag& said, const Subject& subject,
                    const EditScope& scope) {
  const Point2& point = said.pose_map.position;
  const Occupancy there = scope.map.map().at(requireInside(scope, point));
  if (request.force) {
    if (there == Occupancy::kUnknown) {
      refuse(EditErrorCode::kOutside, inWords(point) + " lies in unknown space");
    }
    return asGiven(request, said, subject, scope);
  }
  const auto known = findKnownDoor(request, said, scope);
  const NarrowPlaceQuery query = queryFor(request, said, scope);
  const auto place = findNarrowPlace(scope.map.map(), query);
  if (known && (!place || known->cost <= costOfPlace(place->width, place->distance))) {
    return {known->tag->pose_map, known->tag->width, known->tag,
            "names the door " + inWords(known->distance) + " m from where it was given"};
  }
  if (place) {
    return {place->pose_map, place->width, nullptr,
            "in the passage " + inWords(place->width) + " m wide, " + inWords(place->distance) +
                " m from where it was given"};
  }
  if (there == Occupancy::kUnknown) {
    refuse(EditErrorCode::kOutside,
           inWords(point) + " lies in unknown space, and no passage is near");
  }
  if (there == Occupancy::kFree) refuseFar(query, scope);
  return {said.pose_map, said.width, nullptr, "in an obstacle: a closed door, it parts no areas"};
}

DoorTag withTexts(DoorTag tag, const DoorTag& said, bool by_name) {
  if (said.state != DoorState::kUnknown) tag.state = said.state;
  tag.properties = merged(std::move(tag.properties), said.properties);
  tag.name = newName(tag.name, tag.properties, said.name, by_name);
  return tag;
}

/// Puts what was said on the door that is meant.
Edit nameDoor(const AddTag& request, const DoorTag& said, const DoorPlace& place,
              const EditScope& scope) {
  const DoorTag& known = *place.known;
  const bool is_given = known.source != TagSource::kAutomatic && !known.absent;
  const bool same_name = said.name.empty() || isCalled(known.name, known.properties, said.name);
  if (is_given && !same_name && !request.replace && said.id != known.id) {
    refuse(EditErrorCode::kNameTaken,
           "there is " + called(known) + " already; rename it by its id or with replace");
  }
  DoorTag tag = withTexts(known, said, said.id == DoorId{0} && same_name);
  tag.pose_map = place.pose_map;
  tag.width = place.width;
  tag.absent = false;
  const std::string back = known.absent ? "is a door again; " : "";
  return conclude({std::move(tag), {}, {}, back + place.message}, KnownTag{known}, said.source,
                  scope);
}

/// Puts a known or a new door where none is, or in the place of another.
Edit placeDoor(const AddTag& request, const DoorTag& said, const Subject& subject,
               const DoorPlace& place, const EditScope& scope) {
  Decision decision;
  DoorTag tag = said;
  tag.properties = merged({}, said.properties);
  if (subject.known) {
    tag = withTexts(std::get<DoorTag>(subject.known->tag), said, subject.by_name);
  }
  tag.pose_map = place.pose_map;
  tag.width = place.width;
  tag.absent = false;
  decision.message = place.message;
  const DoorTag* other = place.known;
  if (other && other->source != TagSource::kAutomatic && !other->absent) {
    if (!request.replace) {
      refuse(EditErrorCode::kNameTaken,
             "there is " + called(*other) + " already; replace puts another door there");
    }
    const std::string reason = called(tag) + " was put in its place";
    decision.before.emplace_back(DeferTag{{*other, {}, reason}});
    decision.message += "; " + called(*other) + " waits, as " + reason;
  } else if (other) {
    decision.before.emplace_back(DropTag{TagKind::kDoor, static_cast<std::uint32_t>(other->id)});
  }
  decision.tag = std::move(tag);
  return conclude(std::move(decision), subject.known, said.source, scope);
}

/// Changes what is said of a door, but not where it is.
Edit changeDoor(const DoorTag& said, const KnownTag& known, const EditScope& scope) {
  DoorTag tag = withTexts(std::get<DoorTag>(known.tag), said, false);
  if (said.width > 0) tag.width = said.width;
  tag.absent = false;
  const std::string reason = known.pending ? known.pending->reason : std::string();
  return conclude({std::move(tag), reason, {}, "is changed"}, known, said.source, scope);
}

}  // namespace

Edit decideDoor(const AddTag& request, const DoorTag& given, const EditScope& scope) {
  DoorTag said = given;
  if (said.source == TagSource::kAutomatic) said.source = TagSource::kManual;
  requireWidth(said.width, scope);
  const Subject subject = findSubject(request, scope);
  if (request.placement == Placement::kUnchanged) return changeDoor(said, *subject.known, scope);
  requireFinite(said.pose_map.position,
                request.placement == Placement::kAnyHeading ? 0 : said.pose_map.yaw);
  const DoorPlace place = findPlace(request, said, subject, scope);
  const bool is_there =
      place.known &&
      (!subject.known || (!subject.known->pending &&
                          idOf(subject.known->tag) == static_cast<std::uint32_t>(place.known->id)));
  if (is_there) return nameDoor(request, said, place, scope);
  if (subject.by_name && !request.replace) {
    refuse(EditErrorCode::kNameTaken, "'" + said.name + "' is what " + called(subject.known->tag) +
                                          " is called; replace moves it here");
  }
  return placeDoor(request, said, subject, place, scope);
}

}  // namespace agrid
