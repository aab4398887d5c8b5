// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "agrid/dialogue/grammar.h"
#include "dialogue/pattern.h"

namespace agrid::dialogue {

/// Something that sentences can mean.
struct Intent {
  std::string key;                   ///< in the grammar's file
  std::vector<std::string> one_of;   ///< slots one of which there must be; empty: no such
  std::vector<std::string> allowed;  ///< further slots
  /// The meaning of what fills the slots; the distance is a number by then.
  std::function<Utterance(const Slots&, const GrammarTables&)> meaning;
};

/// Every intent, by key, in the order of the documentation.
const std::vector<Intent>& allIntents();

/// A length as it is said: '2', '2.5', '1,5' or one of the grammar's words [m].
std::optional<double> numberIn(const std::string& text, const GrammarTables& tables);

}  // namespace agrid::dialogue
