// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "agrid/semantic_map.h"

namespace agrid {

/// Something on the map that has a name; points into the SemanticMap it was found in.
using Thing = std::variant<const Area*, const Door*, const ObjectTag*>;

TagKind kindOf(const Thing& thing);
std::uint32_t idOf(const Thing& thing);
const std::string& nameOf(const Thing& thing);
/// Where a thing lies, map frame [m]: an area's anchor, a door's middle, an object's centre.
Point2 positionOf(const Thing& thing);

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

/// Why a word means nothing.
enum class LookupErrorCode {
  kBadName,     ///< no thing could ever be called so, see problemOfName
  kUnknownName  ///< nothing is
};

/// A word that means nothing; `what()` is for a person and lists the closest names.
class LookupError : public std::runtime_error {
 public:
  /// @param closest  up to three names, the nearest first
  LookupError(LookupErrorCode code, const std::string& what, std::string word = {},
              std::vector<std::string> closest = {})
      : std::runtime_error(what),
        code_(code),
        word_(std::move(word)),
        closest_(std::move(closest)) {}
  LookupErrorCode code() const { return code_; }
  const std::string& word() const { return word_; }  ///< empty if it is a bad name
  const std::vector<std::string>& closest() const { return closest_; }

 private:
  LookupErrorCode code_;
  std::string word_;
  std::vector<std::string> closest_;
};

/// The things meant by a word: those of that name or alias, as written or else whatever the case;
/// or else those of that category; or else the area with that number as its id; or else, where a
/// category may be given, the areas that nobody gave a category and whose guessed one it is, with a
/// remark that says so. An alias is a property of that key, several being separated by commas.
/// Areas come first, then objects, then doors, each in the map's order.
/// @throws LookupError if nothing is meant
FoundThings findThings(const SemanticMap& map, const std::string& word, const LookupScope& scope);

/// The name and the aliases of a thing.
std::vector<std::string> allNamesOf(const Thing& thing);

/// The remark on what was found and a message about what became of it, either of which may be
/// empty.
std::string withRemark(const FoundThings& found, const std::string& message);

}  // namespace agrid
