// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "agrid/semantic_map/object_area.h"
#include "agrid/tags/name.h"
#include "dialogue/situation.h"

namespace agrid::dialogue {
namespace {

constexpr double kPi = 3.14159265358979323846;

void requireName(const std::string& name, const Situation& situation) {
  if (!problemOfName(name).empty()) throw CannotDo(situation.say("bad_name"));
}

/// The category itself, or with the lowest number that makes it a name that no other thing has.
/// @param own  of the thing that is to be named
template <typename Held, typename Id>
std::string firstFreeName(const std::string& category, const std::vector<Held>& held, Id own) {
  for (std::size_t number = 1;; ++number) {
    const std::string name = number == 1 ? category : category + "_" + std::to_string(number);
    const bool taken = std::any_of(held.begin(), held.end(), [&](const Held& thing) {
      return thing.id != own && foldCase(thing.name) == foldCase(name);
    });
    if (!taken) return name;
  }
}

/// How far the robot's heading is turned towards a side.
double turnTo(Side side) {
  switch (side) {
    case Side::kLeft:
      return kPi / 2;
    case Side::kRight:
      return -kPi / 2;
    case Side::kBehind:
      return kPi;
    default:
      return 0;
  }
}

/// Where something is said to be, x pointing away from the robot.
Pose2 poseOf(const Spot& spot, const Situation& situation) {
  const Pose2& robot = requireRobot(situation);
  const double away =
      spot.side == Side::kHere ? 0 : spot.distance.value_or(situation.params.object_distance);
  return robot * Pose2{Point2::Zero(), turnTo(spot.side)} * Pose2{Point2(away, 0), 0};
}

std::vector<const ObjectTag*> objectsMeant(const std::string& word, const Situation& situation) {
  std::vector<const ObjectTag*> objects;
  try {
    for (const Thing& thing : findThings(situation.map, word, {false, true}).things) {
      if (const auto* object = std::get_if<const ObjectTag*>(&thing)) objects.push_back(*object);
    }
  } catch (const LookupError& error) {
    if (error.code() != LookupErrorCode::kUnknownName) throw;
  }
  return objects;
}

/// The object that is meant, or a new one of that name.
ObjectTag objectMeant(const SaidObject& said, const Situation& situation) {
  ObjectTag object;
  if (!said.category.empty()) {
    requireName(said.category, situation);
    object.category = said.category;
    object.name = firstFreeName(said.category, situation.map.knowledge.objects, object.id);
    return object;
  }
  requireName(said.name, situation);
  const std::vector<const ObjectTag*> known = objectsMeant(said.name, situation);
  if (known.size() > 1) {
    const std::vector<Thing> things(known.begin(), known.end());
    throw CannotDo(situation.say("several_meant",
                                 {{"word", said.name}, {"names", situation.namesOf(things)}}));
  }
  if (!known.empty()) return *known.front();
  object.name = said.name;
  return object;
}

/// A tag that says the same of a thing as is known, under another name.
struct Renamed {
  const std::string& name;

  Tag operator()(const Area* area) const {
    AreaTag tag;
    tag.id = area->id;
    tag.name = name;
    tag.seed_map = area->anchor_map;
    tag.source = TagSource::kInteraction;
    return tag;
  }
  Tag operator()(const Door* door) const {
    DoorTag tag;
    tag.id = door->id;
    tag.name = name;
    tag.pose_map = poseOf(*door);
    tag.source = TagSource::kInteraction;
    return tag;
  }
  Tag operator()(const ObjectTag* object) const {
    ObjectTag tag = *object;
    tag.name = name;
    tag.source = TagSource::kInteraction;
    return tag;
  }
};

}  // namespace

Reply replyTo(const SaidArea& said, const Situation& situation) {
  const Pose2& robot = requireRobot(situation);
  requireName(said.name.empty() ? said.category : said.name, situation);
  const Area* area = areaAt(situation.map, robot.position);
  AreaTag tag;
  tag.name = said.name;
  tag.category = said.category;
  tag.source = TagSource::kInteraction;
  tag.seed_map = area ? area->anchor_map : robot.position;
  if (area) tag.id = area->id;
  const bool has_a_name = area && area->source != TagSource::kAutomatic;
  if (said.name.empty() && !has_a_name) {
    tag.name = firstFreeName(said.category, situation.map.area_map.areas, tag.id);
  }
  Reply reply{TagToPut{tag, area != nullptr},
              said.name.empty() ? situation.say("area_is_a", {{"category", said.category}})
                                : situation.say("area_named", {{"name", said.name}}),
              {}};
  if (area) reply.things = {area};
  return reply;
}

Reply replyTo(const SaidDoor& said, const Situation& situation) {
  DoorTag tag;
  tag.pose_map = poseOf(said.spot, situation);
  tag.source = TagSource::kInteraction;
  tag.name = said.name;
  if (said.name.empty()) return {TagToPut{tag}, situation.say("door_added"), {}};
  requireName(said.name, situation);
  return {TagToPut{tag}, situation.say("door_added_named", {{"name", said.name}}), {}};
}

Reply replyTo(const SaidObject& said, const Situation& situation) {
  ObjectTag tag = objectMeant(said, situation);
  tag.pose_map = poseOf(said.spot, situation);
  tag.pose_map.yaw += said.spot.side == Side::kHere ? 0 : kPi;  // its front is where the robot is
  tag.source = TagSource::kInteraction;
  const std::string key = tag.id == ObjectId{} ? "object_added" : "object_moved";
  const Area* area = areaOf(situation.map, tag);
  return {TagToPut{tag},
          area ? situation.say(key + "_in", {{"name", tag.name}, {"area", area->name}})
               : situation.say(key, {{"name", tag.name}}),
          {}};
}

Reply replyTo(const SaidName& said, const Situation& situation) {
  requireName(said.name, situation);
  Thing thing;
  if (said.thing.empty()) {
    thing = &doorMeant({}, situation);
  } else {
    const std::vector<Thing> things = findThings(situation.map, said.thing, {true, true}).things;
    if (things.size() > 1) {
      throw CannotDo(situation.say("several_meant",
                                   {{"word", said.thing}, {"names", situation.namesOf(things)}}));
    }
    thing = things.front();
  }
  return {TagToPut{std::visit(Renamed{said.name}, thing), true},
          situation.say("renamed", {{"thing", nameOf(thing)}, {"name", said.name}}),
          {thing}};
}

Reply replyTo(const SaidForget& said, const Situation& situation) {
  const std::vector<Thing> things = findThings(situation.map, said.thing, {true, true}).things;
  if (things.size() > 1) {
    throw CannotDo(situation.say("several_meant",
                                 {{"word", said.thing}, {"names", situation.namesOf(things)}}));
  }
  constexpr std::array<TagKind, 3> kKinds = {TagKind::kArea, TagKind::kDoor, TagKind::kObject};
  const auto id = std::visit([](const auto* held) { return static_cast<std::uint32_t>(held->id); },
                             things.front());
  return {TagToDrop{kKinds.at(things.front().index()), id},
          situation.say("forgotten", {{"name", nameOf(things.front())}}), things};
}

}  // namespace agrid::dialogue
