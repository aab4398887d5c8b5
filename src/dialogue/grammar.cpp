// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/grammar.h"

#include <utility>

#include "dialogue/grammar_tables.h"
#include "dialogue/pattern_match.h"

namespace agrid::dialogue {

Utterance understand(const Grammar& grammar, const std::string& text) {
  const GrammarTables& tables = grammar.tables();
  const auto said = sentenceOf(text);
  if (!said) return NotUnderstood{};
  const Sentence sentence = withoutPhrases(*said, tables.ignored);
  PatternMatcher matcher(sentence, [&](const std::u32string& slot, const std::u32string& words) {
    return slot != U"distance" || numberIn(utf8Of(words), tables);
  });
  const Way* best_way = nullptr;
  Fit best;
  for (const Way& way : tables.ways) {
    auto fit = matcher.fit(way.pattern);
    if (!fit || (best_way && fit->letters <= best.letters)) continue;
    best_way = &way;
    best = *std::move(fit);
  }
  return best_way ? best_way->intent->meaning(best.slots, tables) : NotUnderstood{};
}

}  // namespace agrid::dialogue
