// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "agrid/semantic_map/object_area.h"
#include "agrid/tags/name.h"
#include "dialogue/situation.h"

namespace agrid::dialogue {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string nameOfArea(const SemanticMap& map, AreaId id) {
  const Area* area = findArea(map, id);
  return area ? area->name : std::string();
}

/// Says where a thing is, without the robot.
struct PlaceText {
  const Situation& situation;

  std::string operator()(const Area* area) const {
    std::set<std::string> beside;  // each once, though there may be two doors
    for (const Door& door : situation.map.area_map.doors) {
      for (std::size_t side = 0; side < 2; ++side) {
        const std::string other = nameOfArea(situation.map, door.areas[1 - side]);
        if (door.areas[side] == area->id && !other.empty()) beside.insert(other);
      }
    }
    if (beside.empty()) return situation.say("area_is_alone", {{"name", area->name}});
    const std::string names = listText(situation.tables, {beside.begin(), beside.end()});
    return situation.say("area_is_next_to", {{"name", area->name}, {"names", names}});
  }
  std::string operator()(const Door* door) const {
    const std::string one = nameOfArea(situation.map, door->areas[0]);
    const std::string other = nameOfArea(situation.map, door->areas[1]);
    if (one.empty() || other.empty()) {
      return situation.say("door_is_of", {{"name", door->name}, {"area", one + other}});
    }
    return situation.say("door_is_between",
                         {{"name", door->name}, {"area", one}, {"other_area", other}});
  }
  std::string operator()(const ObjectTag* object) const {
    const Area* area = areaOf(situation.map, *object);
    if (!area) return situation.say("object_is_somewhere", {{"name", object->name}});
    return situation.say("object_is_in", {{"name", object->name}, {"area", area->name}});
  }
};

std::string sideText(const Point2& point, const Situation& situation) {
  const Point2 seen = inverse(*situation.robot) * point;
  constexpr double kQuarter = kPi / 4;
  const double bearing = std::atan2(seen.y(), seen.x());
  if (std::abs(bearing) <= kQuarter) return situation.say("side_front");
  if (std::abs(bearing) >= 3 * kQuarter) return situation.say("side_behind");
  return situation.say(bearing > 0 ? "side_left" : "side_right");
}

std::string whereText(const Thing& thing, const Situation& situation) {
  const std::string answer = std::visit(PlaceText{situation}, thing);
  if (!situation.robot) return situation.say("without_direction", {{"answer", answer}});
  const auto* area = std::get_if<const Area*>(&thing);
  if (area && areaAt(situation.map, situation.robot->position) == *area) {
    return situation.say("you_are_there", {{"name", nameOf(thing)}});
  }
  return situation.say("with_direction",
                       {{"answer", answer},
                        {"distance", lengthText(situation.tables, situation.distanceTo(thing))},
                        {"side", sideText(positionOf(thing), situation)}});
}

/// As many items as may be named, and how many more there are.
std::string shortList(std::vector<std::string> items, const Situation& situation) {
  const std::size_t most = situation.params.most_named;
  if (items.size() <= most) return listText(situation.tables, items);
  const std::string more = std::to_string(items.size() - most);
  items.resize(most);
  std::string named = items.front();
  for (std::size_t i = 1; i < most; ++i) named += situation.say("list_separator") + items[i];
  return situation.say("and_more", {{"things", named}, {"count", more}});
}

}  // namespace

QueryAnswer answerTo(const AskedWhere& asked, const Situation& situation) {
  std::vector<Related> found;
  for (const Thing& thing : findThings(situation.map, asked.thing, {true, true}).things) {
    found.push_back({thing, situation.robot ? situation.distanceTo(thing)
                                            : std::numeric_limits<double>::quiet_NaN()});
  }
  if (situation.robot) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Related& a, const Related& b) { return a.distance < b.distance; });
  }
  QueryAnswer answer;
  for (std::size_t i = 0; i < found.size(); ++i) {
    answer.things.push_back(found[i].thing);
    answer.distances.push_back(found[i].distance);
    if (i >= situation.params.most_named) continue;
    answer.sentence += (i == 0 ? "" : " ") + whereText(found[i].thing, situation);
  }
  return answer;
}

QueryAnswer answerTo(const AskedArea&, const Situation& situation) {
  if (!situation.robot) return {QueryStatus::kNoPose, situation.say("no_pose"), {}, {}};
  const Area* area = areaAt(situation.map, situation.robot->position);
  if (!area) return {QueryStatus::kAnswered, situation.say("no_area_here"), {}, {}};
  const bool says_more =
      !area->category.empty() && foldCase(area->category) != foldCase(area->name);
  const std::string sentence =
      says_more
          ? situation.say("area_here_is_a", {{"name", area->name}, {"category", area->category}})
          : situation.say("area_here", {{"name", area->name}});
  return {QueryStatus::kAnswered, sentence, {area}, {0}};
}

QueryAnswer answerTo(const Question& question, const Situation& situation) {
  if (needsRobot(question) && !situation.robot) {
    return {QueryStatus::kNoPose, situation.say("no_pose"), {}, {}};
  }
  QueryAnswer answer;
  std::vector<std::string> items;
  for (const Related& related :
       findRelated(situation.map, question, situation.robot, situation.params.relations)) {
    answer.things.push_back(related.thing);
    answer.distances.push_back(related.distance);
    const std::string& name = nameOf(related.thing);
    items.push_back(
        question.relation == Relation::kIn
            ? name
            : situation.say(
                  "thing_at",
                  {{"name", name}, {"distance", lengthText(situation.tables, related.distance)}}));
  }
  const auto relation = relationNames().at(static_cast<std::size_t>(question.relation));
  const std::string place = question.place_is_robot ? situation.say("the_robot") : question.place;
  const std::string phrase = situation.say("relation_" + relation, {{"place", place}});
  answer.sentence =
      items.empty() ? situation.say("found_nothing", {{"relation", phrase}})
                    : situation.say("found", {{"relation", phrase},
                                              {"things", shortList(std::move(items), situation)}});
  return answer;
}

}  // namespace agrid::dialogue
