// SPDX-License-Identifier: BSD-3-Clause
#include "tools/place_findings.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "agrid/tags/name.h"

namespace agrid::tools {
namespace {

/// "areas 1 'a' and 2 'b'".
template <typename T>
std::string listed(const std::vector<const T*>& tags) {
  static const char* const kKinds[] = {"areas ", "doors ", "objects "};
  std::vector<std::string> parts;
  for (const T* tag : tags) parts.push_back(numbered(*tag));
  return kKinds[Tag(*tags.front()).index()] + enumerated(parts);
}

template <typename T>
void findNamesakes(const std::vector<T>& tags, Sentences& findings) {
  std::map<std::string, std::vector<const T*>> by_name;
  for (const T& tag : tags) {
    if (!tag.name.empty()) by_name[foldCase(tag.name)].push_back(&tag);
  }
  for (const auto& [unused, namesakes] : by_name) {
    if (namesakes.size() < 2) continue;
    findings.addOn(*namesakes.front(), listed(namesakes) + " have the same name");
  }
}

void findDoorSides(const PlaceView& view, Sentences& findings) {
  for (const PlaceView::DoorSides& sides : view.doors) {
    const auto& [first, second] = sides.areas;
    if (!first && !second) {
      findings.say(sides.door, "has no area on either side");
    } else if (!first || !second) {
      findings.say(sides.door,
                   "has an area on one side only: " + described(first ? *first : *second));
    } else if (first->id == second->id) {
      findings.say(sides.door, "has the same area on both sides: " + described(*first));
    }
  }
}

void findUnreachable(const PlaceView& view, Sentences& findings) {
  if (view.knowledge.areas.size() < 2) return;
  std::set<AreaId> reached;
  for (const PlaceView::DoorSides& sides : view.doors) {
    const auto& [first, second] = sides.areas;
    if (first && second && first->id != second->id) reached.insert({first->id, second->id});
  }
  for (const AreaTag& area : view.knowledge.areas) {
    if (reached.count(area.id) == 0) findings.say(area, "cannot be reached: no door leads there");
  }
}

void findCrowdedAreas(const PlaceView& view, Sentences& findings) {
  std::map<AreaId, std::vector<const AreaTag*>> by_place;
  for (std::size_t i = 0; i < view.at_seed.size(); ++i) {
    if (view.at_seed[i] != AreaId{0}) by_place[view.at_seed[i]].push_back(&view.seeds[i]);
  }
  for (const auto& [place, tags] : by_place) {
    if (tags.size() < 2) continue;
    const AreaTag* owner = findTag(view.knowledge, place);
    findings.addOn(*tags.front(), "the seeds of " + listed(tags) + " lie in one area" +
                                      (owner ? ": " + numbered(*owner) : ""));
  }
}

}  // namespace

void findInTags(const Knowledge& knowledge, Sentences& findings) {
  findNamesakes(knowledge.areas, findings);
  findNamesakes(knowledge.doors, findings);
  findNamesakes(knowledge.objects, findings);
  for (const PendingTag& pending : knowledge.pending) {
    findings.say(pending.tag, "waits: " + pending.reason);
  }
}

void findInPlace(const PlaceView& view, Sentences& findings) {
  findDoorSides(view, findings);
  findUnreachable(view, findings);
  findCrowdedAreas(view, findings);
  for (const ObjectTag& object : view.lost_objects) findings.say(object, "lies in no area");
  for (const std::string& warning : view.warnings) findings.addOnPlace(warning);
}

}  // namespace agrid::tools
