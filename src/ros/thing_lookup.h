// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "agrid/semantic_map.h"

namespace agrid_map_ros {

/// Something on the map that has a name; points into the SemanticMap it was found in.
using Thing = std::variant<const agrid::Area*, const agrid::Door*, const agrid::ObjectTag*>;

/// By which words things are found.
struct LookupScope {
  bool doors = false;
  bool categories = false;
};

/// The things meant by a word.
struct FoundThings {
  std::vector<Thing> things;
  std::string remark;  ///< what the asker should know about them; empty: nothing
};

/// The things meant by a word: those of that name or alias, as written or else whatever the case;
/// or else those of that category; or else the area with that number as its id; or else, where a
/// category may be given, the areas that nobody gave a category and whose guessed one it is, with a
/// remark that says so. An alias is a property of that key, several being separated by commas.
/// @throws RequestError INVALID_REQUEST if the word is empty, longer than 256 bytes or holds a
///         control character; UNKNOWN_NAME, with the closest names, if nothing is meant
FoundThings findThings(const agrid::SemanticMap& map, const std::string& word,
                       const LookupScope& scope);

/// The remark on what was found and a message about what became of it, either of which may be
/// empty.
std::string withRemark(const FoundThings& found, const std::string& message);

}  // namespace agrid_map_ros
