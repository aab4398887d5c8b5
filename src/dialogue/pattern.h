// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "dialogue/sentence.h"

namespace agrid::dialogue {

/// A part of a pattern.
struct PatternPart {
  enum class Kind {
    kText,    ///< must be there
    kAny,     ///< any words, at least a character
    kChoice,  ///< one of the choices
    kSlot     ///< one of the choices, which is remembered
  };
  using Sequence = std::vector<PatternPart>;

  Kind kind = Kind::kText;
  std::u32string text;            ///< folded; of a slot, its name
  std::vector<Sequence> choices;  ///< an empty one: nothing need be there
};

using Pattern = PatternPart::Sequence;

/// What fills the slots: their names and texts.
using Slots = std::map<std::string, std::string>;

/// A pattern that breaks the rules; the message says which.
class PatternError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lists of phrases that patterns refer to by name; a phrase is a pattern.
using WordLists = std::map<std::string, std::vector<std::string>>;

/// Reads a pattern (doc/dialogue.md has its rules): (a|b) one of, [a|b] one of or none, <list> one
/// of a list, {slot} any words, {slot:pattern} words that fit, * any words.
/// @param lists  nullptr: the pattern is of a list itself and can't refer to another
/// @throws PatternError
Pattern parsePattern(const std::string& text, const WordLists* lists);

/// Between how many and how many of some slots a sentence that fits has.
struct SlotCount {
  std::size_t least = 0;
  std::size_t most = 0;
};

SlotCount countSlots(const Pattern& pattern, const std::vector<std::string>& names);
/// The names of all slots.
std::set<std::string> slotNames(const Pattern& pattern);
/// The fewest letters of its own that a pattern has, without the spaces.
std::size_t leastLetters(const Pattern& pattern);

}  // namespace agrid::dialogue
