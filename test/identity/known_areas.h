// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "agrid/identity/recognition.h"
#include "agrid/semantic_map.h"

namespace agrid::test {

/// What is known after a first map, its area `id` named by a person.
inline Knowledge named(const SemanticMap& map, std::uint32_t id, const std::string& name) {
  Knowledge known = recognise({}, "", map, "map").knowledge;
  for (AreaTag& tag : known.areas) {
    if (tag.id != AreaId{id}) continue;
    tag.name = name;
    tag.source = TagSource::kManual;
  }
  return known;
}

inline Recognition next(const Knowledge& known, const SemanticMap& map) {
  return recognise(known, "map", map, "map");
}

/// "id name" of the area at each letter of a drawing, in the order of the alphabet.
inline std::string at(const Recognition& found, const SemanticMap& map) {
  std::string text;
  for (std::size_t i = 0; i < map.area_map.areas.size(); ++i) {
    for (const AreaTag& tag : found.knowledge.areas) {
      const auto pixel = map.map().geometry().pixelAt(tag.seed_map);
      if (!pixel) continue;
      if (map.area_map.pixel_labels[map.map().geometry().index(*pixel)] != i + 1) continue;
      text += (text.empty() ? "" : ", ") + std::to_string(static_cast<std::uint32_t>(tag.id)) +
              " " + tag.name;
    }
  }
  return text;
}

inline std::string waiting(const Recognition& found) {
  std::string text;
  for (const PendingTag& p : found.knowledge.pending) {
    text += std::to_string(idOf(p.tag)) + " " + nameOf(p.tag) + ": " + p.reason + "\n";
  }
  return text;
}

}  // namespace agrid::test
