// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/object_area.h"
#include "exchange/plain_text.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

template <typename Id>
std::string numberOf(Id id) {
  return std::to_string(static_cast<std::uint32_t>(id));
}

/// A quoted atom (ISO/IEC 13211-1, 6.4.2).
std::string atom(const std::string& text) {
  std::string quoted = "'";
  for (const char c : plainText(text)) {
    if (c == '\'' || c == '\\') quoted += c == '\'' ? '\'' : '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string fact(const char* name, const std::vector<std::string>& arguments) {
  std::string text = std::string(name) + "(";
  for (const std::string& argument : arguments) {
    text += (text.back() == '(' ? "" : ", ") + argument;
  }
  return text + ").\n";
}

/// Facts one predicate after the other, as Prolog wants them.
struct Facts {
  std::string things;
  std::string categories;
  std::string places;
  std::string links;
  std::string states;
  std::string properties;

  template <typename Thing>
  void add(const char* kind, const Thing& thing, const Point2& place_map) {
    const std::string id = numberOf(thing.id);
    things += fact(kind, {id, atom(thing.name)});
    places += fact("place", {kind, id, plainNumber(place_map.x()), plainNumber(place_map.y())});
    for (const auto& [key, value] : thing.properties) {
      properties += fact("property", {kind, id, atom(key), atom(value)});
    }
  }
};

}  // namespace

std::string factsText(const SemanticMap& map, const std::string& frame_id) {
  Facts facts;
  for (const Area& area : map.area_map.areas) {
    facts.add("area", area, area.anchor_map);
    const std::string& category = area.category.empty() ? area.category_guess : area.category;
    if (category.empty()) continue;
    facts.categories += fact("category", {"area", numberOf(area.id), atom(category)});
  }
  for (const Door& door : map.area_map.doors) {
    facts.add("door", door, door.jambs_map.midpoint());
    facts.links +=
        fact("connects", {numberOf(door.id), numberOf(door.areas[0]), numberOf(door.areas[1])});
    facts.states += fact("state", {numberOf(door.id), wordOf(door.state)});
  }
  std::string within;
  for (const ObjectTag& object : map.knowledge.objects) {
    facts.add("object", object, object.pose_map.position);
    if (!object.category.empty()) {
      facts.categories += fact("category", {"object", numberOf(object.id), atom(object.category)});
    }
    if (const Area* area = areaOf(map, object)) {
      within += fact("in", {numberOf(object.id), numberOf(area->id)});
    }
  }
  return ":- encoding(utf8).\n"
         "% metres in the frame of frame/1; area 0 is the outside\n"
         ":- dynamic area/2, door/2, object/2, category/3, place/4, connects/3, state/2, in/2, "
         "property/4.\n"
         ":- discontiguous area/2, door/2, object/2.\n" +
         fact("frame", {atom(frame_id)}) + facts.things + facts.categories + facts.places +
         facts.links + facts.states + within + facts.properties;
}

}  // namespace agrid
