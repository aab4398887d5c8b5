// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "pipeline/edit_decisions.h"
#include "pipeline/edit_names.h"

namespace agrid {
namespace {

constexpr double kGreatestHeight = 1000;  // [m]
constexpr double kSamePlace = 1e-6;       // what sending a pose through a frame and back changes

void requireSize(const ObjectTag& said, const EditScope& scope) {
  const double diagonal =
      std::hypot(scope.geometry().width, scope.geometry().height) * scope.geometry().resolution;
  const auto require = [](double value, double greatest, const char* what) {
    if (value >= 0 && value <= greatest) return;  // not NaN
    refuse(EditErrorCode::kInvalid,
           std::string("the object's ") + what + " must lie in [0, " + inWords(greatest) + "] m");
  };
  require(said.size.x(), diagonal, "length");
  require(said.size.y(), diagonal, "width");
  require(said.height, kGreatestHeight, "height");
}

bool samePlace(const Pose2& a, const Pose2& b) {
  return (a.position - b.position).norm() <= kSamePlace &&
         std::abs(std::remainder(a.yaw - b.yaw, 2 * M_PI)) <= kSamePlace;
}

/// An object without a name that is known already, but for its name.
std::optional<KnownTag> findSame(const ObjectTag& said, const EditScope& scope) {
  for (const ObjectTag& object : scope.known().objects) {
    if (samePlace(object.pose_map, said.pose_map) && object.category == said.category &&
        object.size == said.size && object.height == said.height &&
        object.properties == said.properties) {
      return KnownTag{object};
    }
  }
  return std::nullopt;
}

ObjectTag changed(ObjectTag tag, const ObjectTag& said, bool by_name) {
  if (!said.category.empty()) tag.category = said.category;
  if (said.size != Point2::Zero()) tag.size = said.size;
  if (said.height != 0) tag.height = said.height;
  tag.properties = merged(std::move(tag.properties), said.properties);
  tag.name = newName(tag.name, tag.properties, said.name, by_name);
  return tag;
}

/// What is said of where an object may be; empty: nothing.
std::string remarkOnPlace(const Point2& position, const EditScope& scope) {
  const Pixel pixel = requireInside(scope, position);
  if (scope.map.map().at(pixel) != Occupancy::kUnknown) return {};
  if (!scope.params.allow_unknown) {
    refuse(EditErrorCode::kOutside, inWords(position) + " lies in unknown space");
  }
  return " in unknown space";
}

Edit changeObject(const AddTag& request, const ObjectTag& said, const Subject& subject,
                  const std::string& where, const EditScope& scope) {
  const auto& known = std::get<ObjectTag>(subject.known->tag);
  if (known.source != TagSource::kAutomatic && said.source == TagSource::kAutomatic) {
    refuse(
        EditErrorCode::kNameTaken,
        called(known) + " was given by a person; what is found automatically does not change it");
  }
  Pose2 pose = said.pose_map;
  if (request.placement == Placement::kAnyHeading) pose.yaw = known.pose_map.yaw;
  const bool stays = request.placement == Placement::kUnchanged || samePlace(known.pose_map, pose);
  if (subject.by_name && !stays && !request.replace) {
    refuse(EditErrorCode::kNameTaken,
           "'" + said.name + "' is what " + called(known) + " is called; replace moves it here");
  }
  Decision decision;
  ObjectTag tag = changed(known, said, subject.by_name);
  if (!stays) tag.pose_map = pose;
  decision.tag = std::move(tag);
  decision.message = stays ? "is changed" : "is now at " + inWords(pose.position) + where;
  if (request.placement == Placement::kUnchanged && subject.known->pending) {
    decision.waits_because = subject.known->pending->reason;
  }
  return conclude(std::move(decision), subject.known, said.source, scope);
}

}  // namespace

Edit decideObject(const AddTag& request, const ObjectTag& given, const EditScope& scope) {
  ObjectTag said = given;
  requireSize(said, scope);
  Subject subject = findSubject(request, scope);
  const bool stays = request.placement == Placement::kUnchanged;
  if (request.placement == Placement::kAnyHeading) said.pose_map.yaw = 0;
  if (!stays) requireFinite(said.pose_map.position, said.pose_map.yaw);
  const std::string where = stays ? "" : remarkOnPlace(said.pose_map.position, scope);
  said.properties = merged({}, said.properties);
  if (!subject.known && said.name.empty()) subject.known = findSame(said, scope);
  if (subject.known) return changeObject(request, said, subject, where, scope);
  const std::string message = "a new object at " + inWords(said.pose_map.position) + where;
  const TagSource source = said.source;
  return conclude({std::move(said), {}, {}, message}, std::nullopt, source, scope);
}

}  // namespace agrid
