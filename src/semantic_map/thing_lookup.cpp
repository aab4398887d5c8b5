// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/thing_lookup.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <sstream>

#include "agrid/tags/name.h"
#include "map/printable.h"
#include "semantic_map/closest_names.h"

namespace agrid {
namespace {

/// What a thing is called.
struct Called {
  Thing thing;
  std::vector<std::string> names;  // its name first, then the aliases
  std::string category;
  std::string guess;  ///< of an area whose category nobody gave
};

std::vector<std::string> namesOf(const std::string& name, const Properties& properties) {
  std::vector<std::string> names = {name};
  const auto alias = properties.find("alias");
  if (alias == properties.end()) return names;
  std::istringstream list(alias->second);
  for (std::string part; std::getline(list, part, ',');) {
    const std::size_t begin = part.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    names.push_back(part.substr(begin, part.find_last_not_of(' ') + 1 - begin));
  }
  return names;
}

std::vector<Called> allThings(const SemanticMap& map, const LookupScope& scope) {
  std::vector<Called> things;
  for (const Area& area : map.area_map.areas) {
    things.push_back({&area, allNamesOf(&area), area.category,
                      area.category.empty() ? area.category_guess : std::string()});
  }
  for (const ObjectTag& object : map.knowledge.objects) {
    things.push_back({&object, allNamesOf(&object), object.category, {}});
  }
  if (!scope.doors) return things;
  for (const Door& door : map.area_map.doors) {
    things.push_back({&door, allNamesOf(&door), {}, {}});
  }
  return things;
}

std::vector<Thing> select(const std::vector<Called>& things,
                          const std::function<bool(const Called&)>& meant) {
  std::vector<Thing> selected;
  for (const Called& called : things) {
    if (meant(called)) selected.push_back(called.thing);
  }
  return selected;
}

std::string asWritten(const std::string& text) { return text; }

void requireName(const std::string& word) {
  const std::string problem = problemOfName(word);
  if (!problem.empty()) throw LookupError(LookupErrorCode::kBadName, problem);
}

[[noreturn]] void throwUnknown(const std::vector<Called>& things, const std::string& word,
                               const LookupScope& scope) {
  std::vector<std::string> known;
  for (const Called& called : things) {
    std::copy_if(called.names.begin(), called.names.end(), std::back_inserter(known),
                 [](const std::string& name) { return !name.empty(); });
    if (scope.categories && !called.category.empty()) known.push_back(called.category);
    if (scope.categories && !called.guess.empty()) known.push_back(called.guess);
  }
  const std::vector<std::string> closest = closestNames(word, known);
  throw LookupError(LookupErrorCode::kUnknownName,
                    "there is no '" + word + "'" +
                        (closest.empty() ? std::string("; nothing has a name yet")
                                         : "; the closest names are: " + joined(closest)),
                    word, closest);
}

struct Position {
  Point2 operator()(const Area* area) const { return area->anchor_map; }
  Point2 operator()(const Door* door) const { return door->jambs_map.midpoint(); }
  Point2 operator()(const ObjectTag* object) const { return object->pose_map.position; }
};

}  // namespace

const std::string& nameOf(const Thing& thing) {
  return std::visit([](const auto* held) -> const std::string& { return held->name; }, thing);
}

TagKind kindOf(const Thing& thing) {
  constexpr std::array<TagKind, 3> kKinds = {TagKind::kArea, TagKind::kDoor, TagKind::kObject};
  return kKinds.at(thing.index());
}

std::uint32_t idOf(const Thing& thing) {
  return std::visit([](const auto* held) { return static_cast<std::uint32_t>(held->id); }, thing);
}

Point2 positionOf(const Thing& thing) { return std::visit(Position{}, thing); }

std::vector<std::string> allNamesOf(const Thing& thing) {
  return std::visit([](const auto* held) { return namesOf(held->name, held->properties); }, thing);
}

FoundThings findThings(const SemanticMap& map, const std::string& word, const LookupScope& scope) {
  requireName(word);
  const std::vector<Called> things = allThings(map, scope);
  for (const auto form : {&asWritten, &foldCase}) {
    const std::string wanted = form(word);
    auto found = select(things, [&](const Called& called) {
      return std::any_of(called.names.begin(), called.names.end(),
                         [&](const std::string& name) { return form(name) == wanted; });
    });
    if (!found.empty()) return {found, {}};
    if (!scope.categories) continue;
    found = select(things, [&](const Called& called) { return form(called.category) == wanted; });
    if (!found.empty()) return {found, {}};
  }
  auto found = select(things, [&](const Called& called) {
    const auto* area = std::get_if<const Area*>(&called.thing);
    return area && std::to_string(static_cast<std::uint32_t>((*area)->id)) == word;
  });
  if (!found.empty()) return {found, {}};
  if (scope.categories) {
    found = select(things, [&](const Called& called) { return called.guess == foldCase(word); });
  }
  if (found.empty()) throwUnknown(things, word, scope);
  return {found, "'" + printable(word) + "' is a guess from the shape: nothing was tagged so"};
}

std::string withRemark(const FoundThings& found, const std::string& message) {
  return found.remark + (found.remark.empty() || message.empty() ? "" : "; ") + message;
}

}  // namespace agrid
