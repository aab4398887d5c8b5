// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "agrid/dialogue/grammar.h"
#include "dialogue/intents.h"
#include "dialogue/pattern.h"

namespace agrid::dialogue {

/// One way to say something, and what it means.
struct Way {
  Pattern pattern;
  const Intent* intent = nullptr;  ///< of the table in intents.h
};

/// What a grammar's file says, made ready.
struct GrammarTables {
  std::vector<Way>
      ways;  ///< those with the most letters of their own first, then in the file's order
  std::vector<std::u32string> ignored;         ///< folded phrases, the longest first
  std::map<std::string, double> numbers;       ///< by their folded words
  std::vector<std::string> robot;              ///< folded words for the robot, as a landmark
  std::map<std::string, TagKind> kinds;        ///< by their folded words
  std::map<std::string, std::string> answers;  ///< templates by key
  std::string decimal_mark = ".";
};

}  // namespace agrid::dialogue
