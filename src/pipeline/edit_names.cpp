// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/edit_names.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "agrid/tags/name.h"
#include "map/printable.h"
#include "pipeline/edit_decisions.h"

namespace agrid {
namespace {

constexpr std::size_t kMostProperties = 64;
constexpr std::size_t kLongestValue = 4096;  // bytes

/// Calls visit with each alias of a thing until it returns true.
template <typename Visit>
bool anyAlias(const Properties& properties, Visit visit) {
  const auto property = properties.find("alias");
  if (property == properties.end()) return false;
  const std::string& list = property->second;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::size_t first = std::min(list.find_first_not_of(' ', begin), end);
    const std::size_t last = list.find_last_not_of(' ', end - 1);
    if (first < end && visit(list.substr(first, last + 1 - first))) return true;
    begin = end + 1;
  }
  return false;
}

bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

char smallAscii(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Whether foldCase(name) == folded, without making a string where ASCII letters tell it.
bool foldsTo(const std::string& name, const std::string& folded) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!isAscii(name[i])) return foldCase(name) == folded;
    if (i >= folded.size() || smallAscii(name[i]) != folded[i]) return false;
  }
  return name.size() == folded.size();
}

bool isCalledFolded(const std::string& name, const Properties& properties,
                    const std::string& folded) {
  return (!name.empty() && foldsTo(name, folded)) ||
         (!properties.empty() &&
          anyAlias(properties, [&](const std::string& alias) { return foldsTo(alias, folded); }));
}

/// The id of the first thing of a list that bears a name.
template <typename Things>
std::optional<std::uint32_t> firstCalled(const Things& things, const std::string& folded,
                                         std::uint32_t but) {
  for (const auto& thing : things) {
    const auto id = static_cast<std::uint32_t>(thing.id);
    if (id != but && isCalledFolded(thing.name, thing.properties, folded)) return id;
  }
  return std::nullopt;
}

/// The id of another thing than `but` that bears a name.
std::optional<std::uint32_t> findCalled(const SemanticMap& map, TagKind kind,
                                        const std::string& name, std::uint32_t but) {
  const std::string folded = foldCase(name);
  const Knowledge& known = map.knowledge;
  std::optional<std::uint32_t> found;
  if (kind == TagKind::kArea) {
    found = firstCalled(known.areas, folded, but);
    if (!found) found = firstCalled(map.area_map.areas, folded, but);  // default names
  } else if (kind == TagKind::kDoor) {
    found = firstCalled(known.doors, folded, but);
    if (!found) found = firstCalled(map.area_map.doors, folded, but);
  } else {
    found = firstCalled(known.objects, folded, but);
  }
  for (auto p = known.pending.begin(); p != known.pending.end() && !found; ++p) {
    if (kindOf(p->tag) != kind || idOf(p->tag) == but) continue;
    const auto bears = [&](const auto& t) { return isCalledFolded(t.name, t.properties, folded); };
    if (std::visit(bears, p->tag)) found = idOf(p->tag);
  }
  return found;
}

const Properties& propertiesOf(const Tag& tag) {
  return std::visit([](const auto& t) -> const Properties& { return t.properties; }, tag);
}

std::string categoryOf(const Tag& tag) {
  if (const auto* area = std::get_if<AreaTag>(&tag)) return area->category;
  if (const auto* object = std::get_if<ObjectTag>(&tag)) return object->category;
  return {};
}

const char* kindName(TagKind kind) {
  return kind == TagKind::kArea ? "area" : kind == TagKind::kDoor ? "door" : "object";
}

void requireText(const std::string& text, const std::string& what) {
  const std::string problem = problemOfName(text);
  if (!problem.empty()) refuse(EditErrorCode::kInvalid, what + problem);
}

void requireProperties(const Properties& properties) {
  if (properties.size() > kMostProperties) {
    refuse(EditErrorCode::kInvalid, "the tag has " + std::to_string(properties.size()) +
                                        " properties, allowed are " +
                                        std::to_string(kMostProperties));
  }
  for (const auto& [key, value] : properties) {
    requireText(key, "a property's key: ");
    if (value.size() > kLongestValue) {
      refuse(EditErrorCode::kInvalid, "the property '" + key + "' has " +
                                          std::to_string(value.size()) + " bytes, allowed are " +
                                          std::to_string(kLongestValue));
    }
    if (printable(value) != value) {
      refuse(EditErrorCode::kInvalid,
             "the property '" + key + "' is not UTF-8 or holds a control character");
    }
  }
  anyAlias(properties, [](const std::string& alias) {
    requireText(alias, "an alias: ");
    return false;
  });
}

/// The lowest number from 2 on, or none, that makes a name of an object which no other one has.
std::string numbered(const SemanticMap& map, const std::string& stem) {
  if (!idOfName(map, TagKind::kObject, stem)) return stem;
  const std::string folded = foldCase(stem) + "_";
  std::vector<bool> taken(map.knowledge.objects.size() + map.knowledge.pending.size() + 3);
  const auto take = [&](const std::string& name) {
    if (name.size() <= folded.size() || name.size() > folded.size() + 6) return;
    if (!foldsTo(name.substr(0, folded.size()), folded)) return;
    std::size_t number = 0;
    for (std::size_t i = folded.size(); i < name.size(); ++i) {
      if (name[i] < '0' || name[i] > '9') return;
      number = number * 10 + static_cast<std::size_t>(name[i] - '0');
    }
    if (number < taken.size()) taken[number] = true;
  };
  for (const ObjectTag& object : map.knowledge.objects) take(object.name);
  for (const PendingTag& pending : map.knowledge.pending) take(nameOf(pending.tag));
  for (std::size_t number = 2;; ++number) {
    if (number < taken.size() && taken[number]) continue;
    const std::string name = stem + "_" + std::to_string(number);
    if (!idOfName(map, TagKind::kObject, name)) return name;
  }
}

}  // namespace

std::optional<std::uint32_t> idOfName(const SemanticMap& map, TagKind kind,
                                      const std::string& name) {
  return findCalled(map, kind, name, 0);
}

bool isCalled(const std::string& name, const Properties& properties, const std::string& word) {
  return isCalledFolded(name, properties, foldCase(word));
}

void requireTexts(const Tag& tag) {
  if (!nameOf(tag).empty()) requireText(nameOf(tag), {});
  const std::string category = categoryOf(tag);
  if (!category.empty()) requireText(category, "the category: ");
  requireProperties(propertiesOf(tag));
}

void requireUniqueNames(const SemanticMap& map, const Tag& tag) {
  const TagKind kind = kindOf(tag);
  const auto require = [&](const std::string& name) {
    if (const auto id = findCalled(map, kind, name, idOf(tag))) {
      const auto other = findKnown(map.knowledge, kind, *id);
      refuse(EditErrorCode::kNameTaken,
             "'" + name + "' is what " +
                 (other ? called(other->tag) : kindName(kind) + (" " + std::to_string(*id))) +
                 " is called");
    }
    return false;
  };
  if (!nameOf(tag).empty()) require(nameOf(tag));
  anyAlias(propertiesOf(tag), require);
}

std::string defaultName(const SemanticMap& map, const Tag& tag) {
  const std::string category = categoryOf(tag);
  if (kindOf(tag) == TagKind::kObject && !category.empty() && category.size() < 240) {
    return numbered(map, category);
  }
  std::string name = kindName(kindOf(tag)) + ("_" + std::to_string(idOf(tag)));
  while (findCalled(map, kindOf(tag), name, idOf(tag))) name += "_";
  return name;
}

std::string called(const Tag& tag) {
  const std::string thing = kindName(kindOf(tag)) + (" " + std::to_string(idOf(tag)));
  return nameOf(tag).empty() ? thing : thing + " '" + nameOf(tag) + "'";
}

}  // namespace agrid
