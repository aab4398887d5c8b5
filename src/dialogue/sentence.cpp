// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/sentence.h"

#include <algorithm>

#include "map/utf8.h"
#include "tags/letter_case.h"

namespace agrid::dialogue {
namespace {

bool isSpace(char32_t c) {
  return c <= 0x20 || (c >= 0x7F && c <= 0xA0) || (c >= 0x2000 && c <= 0x200B) || c == 0x2028 ||
         c == 0x2029 || c == 0x202F || c == 0x3000 || c == 0xFEFF;
}

bool isFullStop(char32_t c) { return c == '.' || c == 0x2026; }

// Words are never separated by a space in these scripts.
bool isIdeograph(char32_t c) { return c >= 0x2E80 && c <= 0x9FFF; }

std::vector<std::u32string> wordsOf(const std::u32string& text) {
  std::vector<std::u32string> words(1);
  for (const char32_t c : text) {
    if (!isSpace(c)) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  for (std::u32string& word : words) {
    const bool last = &word == &words.back() || words.back().empty();
    const auto outside = [last](char32_t c) { return isPunctuation(c) || (last && isFullStop(c)); };
    while (!word.empty() && outside(word.back())) word.pop_back();
    const auto first = std::find_if_not(word.begin(), word.end(), isPunctuation);
    word.erase(word.begin(), first);
  }
  words.erase(std::remove(words.begin(), words.end(), std::u32string()), words.end());
  return words;
}

bool isBoundary(const std::u32string& text, std::size_t before) {
  return before == 0 || before == text.size() || text[before] == ' ' || text[before - 1] == ' ' ||
         isIdeograph(text[before]) || isIdeograph(text[before - 1]);
}

bool startsWith(const std::u32string& text, const std::u32string& phrase) {
  return text.compare(0, phrase.size(), phrase) == 0 && isBoundary(text, phrase.size());
}

bool endsWith(const std::u32string& text, const std::u32string& phrase) {
  return text.size() >= phrase.size() &&
         text.compare(text.size() - phrase.size(), phrase.size(), phrase) == 0 &&
         isBoundary(text, text.size() - phrase.size());
}

void keep(Sentence& sentence, std::size_t first, std::size_t size) {
  while (size > 0 && sentence.folded[first] == ' ') ++first, --size;
  while (size > 0 && sentence.folded[first + size - 1] == ' ') --size;
  sentence.folded = sentence.folded.substr(first, size);
  sentence.as_said = sentence.as_said.substr(first, size);
}

}  // namespace

char32_t plainCharacter(char32_t c) {
  const bool apostrophe = c == 0x2018 || c == 0x2019 || c == 0x02BC || c == '`' || c == 0xB4;
  return apostrophe ? U'\'' : smallLetter(c);
}

bool isPunctuation(char32_t c) {
  static const std::u32string kSigns =
      U",;:!?\"\u00A1\u00BF\u00AB\u00BB\u201C\u201D\u201E\u3001\u3002\uFF01\uFF0C\uFF1A\uFF1F";
  return kSigns.find(c) != std::u32string::npos;
}

std::optional<Sentence> sentenceOf(const std::string& text) {
  if (text.size() > kLongestSentence) return std::nullopt;
  const auto characters = codePointsOf(text);
  if (!characters) return std::nullopt;
  Sentence sentence;
  for (const std::u32string& word : wordsOf(*characters)) {
    if (!sentence.as_said.empty()) sentence.as_said += U' ';
    sentence.as_said += word;
  }
  sentence.folded = sentence.as_said;
  std::transform(sentence.folded.begin(), sentence.folded.end(), sentence.folded.begin(),
                 plainCharacter);
  return sentence;
}

Sentence withoutPhrases(Sentence sentence, const std::vector<std::u32string>& phrases) {
  for (bool found = true; found && !sentence.folded.empty();) {
    found = false;
    for (const std::u32string& phrase : phrases) {
      const std::size_t size = sentence.folded.size();
      if (startsWith(sentence.folded, phrase)) {
        keep(sentence, phrase.size(), size - phrase.size());
      } else if (endsWith(sentence.folded, phrase)) {
        keep(sentence, 0, size - phrase.size());
      }
      found = found || sentence.folded.size() < size;
    }
  }
  return sentence;
}

std::string utf8Of(const std::u32string& text) {
  std::string result;
  for (const char32_t c : text) appendUtf8(result, c);
  return result;
}

}  // namespace agrid::dialogue
