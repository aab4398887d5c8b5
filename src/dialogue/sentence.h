// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace agrid::dialogue {

/// Longer sentences are not understood.
constexpr std::size_t kLongestSentence = 512;  // bytes

/// A sentence as patterns see it: words separated by single spaces, without the punctuation around
/// them. Both texts have the same length, character by character.
struct Sentence {
  std::u32string as_said;
  std::u32string folded;  ///< in small letters, with plain apostrophes
};

/// A character as it is compared: a small letter, a plain apostrophe.
char32_t plainCharacter(char32_t c);

/// Signs around words that are not part of them.
bool isPunctuation(char32_t c);

/// @return nothing if the text is longer than kLongestSentence or not UTF-8
std::optional<Sentence> sentenceOf(const std::string& text);

/// The sentence without the phrases that say nothing, such as 'please', at its beginning and end.
/// @param phrases  folded
Sentence withoutPhrases(Sentence sentence, const std::vector<std::u32string>& phrases);

std::string utf8Of(const std::u32string& text);

}  // namespace agrid::dialogue
