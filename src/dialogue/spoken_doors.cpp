// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "dialogue/situation.h"
#include "semantic_map/shape.h"

namespace agrid::dialogue {
namespace {

const Door& nearestDoor(const Situation& situation) {
  requireRobot(situation);
  const Door* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Door& door : situation.map.area_map.doors) {
    const double distance = situation.distanceTo(&door);
    if (distance < least) {
      least = distance;
      nearest = &door;
    }
  }
  const double reach = situation.params.door_reach;
  if (nearest && least <= reach) return *nearest;
  throw CannotDo(
      situation.say("no_door_here", {{"distance", lengthText(situation.tables, reach)}}));
}

template <typename T>
std::vector<const T*> only(const std::vector<Thing>& things) {
  std::vector<const T*> held;
  for (const Thing& thing : things) {
    if (const auto* one = std::get_if<const T*>(&thing)) held.push_back(*one);
  }
  return held;
}

/// The areas that a word means.
std::vector<const Area*> areasMeant(const std::string& word, const Situation& situation) {
  return only<Area>(findThings(situation.map, word, {true, true}).things);
}

bool leadsTo(const Door& door, const std::vector<const Area*>& areas) {
  return std::any_of(areas.begin(), areas.end(), [&](const Area* area) {
    return std::find(door.areas.begin(), door.areas.end(), area->id) != door.areas.end();
  });
}

/// One of several: that beside the robot, if it is there.
const Door& oneOf(std::vector<const Door*> doors, const std::string& word,
                  const Situation& situation) {
  const auto is_nearer = [&](const Door* a, const Door* b) {
    return situation.distanceTo(a) < situation.distanceTo(b);
  };
  if (doors.size() > 1 && situation.robot) {
    const Door* nearest = *std::min_element(doors.begin(), doors.end(), is_nearer);
    if (situation.distanceTo(nearest) <= situation.params.door_reach) return *nearest;
  }
  if (doors.size() == 1) return *doors.front();
  throw CannotDo(situation.say(
      "several_meant",
      {{"word", word},
       {"names", situation.namesOf(std::vector<Thing>(doors.begin(), doors.end()))}}));
}

const Door& doorOfAreas(const WhichDoor& which, const Situation& situation) {
  std::vector<const Door*> doors;
  const std::vector<const Area*> areas = areasMeant(which.area, situation);
  std::vector<std::string> names = {which.area};
  std::vector<const Area*> others;
  if (!which.other_area.empty()) {
    others = areasMeant(which.other_area, situation);
    names.push_back(which.other_area);
  }
  for (const Door& door : situation.map.area_map.doors) {
    const bool meant = leadsTo(door, areas) && (which.other_area.empty() || leadsTo(door, others));
    if (meant) doors.push_back(&door);
  }
  const std::string shown = listText(situation.tables, names);
  if (doors.empty()) throw CannotDo(situation.say("no_such_door", {{"areas", shown}}));
  return oneOf(doors, which.name.empty() ? shown : which.name, situation);
}

std::vector<const Door*> doorsNamed(const std::string& name, const Situation& situation) {
  return only<Door>(findThings(situation.map, name, {true, false}).things);
}

}  // namespace

const Door& doorMeant(const WhichDoor& which, const Situation& situation) {
  if (which.name.empty() && which.area.empty()) return nearestDoor(situation);
  if (which.name.empty()) return doorOfAreas(which, situation);
  try {
    const std::vector<const Door*> doors = doorsNamed(which.name, situation);
    if (!doors.empty()) return oneOf(doors, which.name, situation);
  } catch (const LookupError&) {
    if (which.area.empty()) throw;
  }
  if (!which.area.empty()) return doorOfAreas(which, situation);
  throw CannotDo(situation.say("no_such_door", {{"areas", which.name}}));
}

Reply replyTo(const SaidState& said, const Situation& situation) {
  const Door& door = doorMeant(said.door, situation);
  const char* key = said.state == DoorState::kOpen     ? "door_is_open"
                    : said.state == DoorState::kClosed ? "door_is_closed"
                                                       : "door_is_unknown";
  return {StateToSet{door.id, said.state}, situation.say(key, {{"name", door.name}}), {&door}};
}

Reply replyTo(const SaidForgetDoor& said, const Situation& situation) {
  const Door& door = doorMeant(said.door, situation);
  return {TagToDrop{TagKind::kDoor, static_cast<std::uint32_t>(door.id)},
          situation.say("forgotten", {{"name", door.name}}),
          {&door}};
}

}  // namespace agrid::dialogue
