// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/pattern.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "map/utf8.h"

namespace agrid::dialogue {
namespace {

using Kind = PatternPart::Kind;
using Choices = std::vector<Pattern>;

constexpr int kDeepest = 8;
constexpr std::size_t kLongestPattern = 1000;  // bytes

/// Reads a pattern by recursive descent.
class Reader {
 public:
  /// @param lists  nullptr: a phrase of a list, which cannot refer to another list
  Reader(std::u32string text, const WordLists* lists) : text_(std::move(text)), lists_(lists) {}

  Pattern all() {
    Pattern pattern = sequence();
    if (at_ < text_.size()) throw PatternError("'" + shown() + "' is not open here");
    return pattern;
  }

 private:
  Pattern sequence() {
    Pattern parts;
    while (at_ < text_.size() &&
           std::u32string(U")]}|>").find(text_[at_]) == std::u32string::npos) {
      PatternPart next = part();
      const bool text_goes_on =
          next.kind == Kind::kText && !parts.empty() && parts.back().kind == Kind::kText;
      if (text_goes_on) {
        parts.back().text += next.text;
      } else {
        parts.push_back(std::move(next));
      }
    }
    return parts;
  }

  Choices choices() {
    if (++depth_ > kDeepest) throw PatternError("brackets are nested too deeply");
    Choices choices = {sequence()};
    while (at_ < text_.size() && text_[at_] == '|') {
      ++at_;
      choices.push_back(sequence());
    }
    --depth_;
    return choices;
  }

  PatternPart part() {
    const char32_t c = text_[at_++];
    if (c == '(' || c == '[') {
      PatternPart part{Kind::kChoice, {}, choices()};
      if (c == '[') part.choices.emplace_back();
      close(c == '(' ? ')' : ']');
      return part;
    }
    if (c == '<') return list();
    if (c == '{') return slot();
    if (c == '*') return {Kind::kAny, {}, {}};
    if (isPunctuation(c)) {
      throw PatternError("leave out '" + utf8Of({c}) + "': sentences are read without it");
    }
    return {Kind::kText, {c < 0x20 ? U' ' : plainCharacter(c)}, {}};
  }

  PatternPart list() {
    const std::string name = utf8Of(word());
    close('>');
    if (!lists_) throw PatternError("a list cannot hold a list");
    const auto found = lists_->find(name);
    if (found == lists_->end()) throw PatternError("there is no list <" + name + ">");
    PatternPart part{Kind::kChoice, {}, {}};
    for (const std::string& phrase : found->second) {
      part.choices.push_back(
          Reader(codePointsOf(phrase).value_or(std::u32string()), nullptr).all());
    }
    return part;
  }

  PatternPart slot() {
    PatternPart part{Kind::kSlot, word(), {{{Kind::kAny, {}, {}}}}};
    if (at_ < text_.size() && text_[at_] == ':') {
      ++at_;
      part.choices = choices();
    }
    close('}');
    return part;
  }

  std::u32string word() {
    std::u32string letters;
    while (at_ < text_.size() && ((text_[at_] >= 'a' && text_[at_] <= 'z') || text_[at_] == '_')) {
      letters += text_[at_++];
    }
    if (letters.empty()) throw PatternError("a name of small letters is missing after '<' or '{'");
    return letters;
  }

  void close(char32_t bracket) {
    if (at_ >= text_.size()) throw PatternError("'" + utf8Of({bracket}) + "' is missing");
    if (text_[at_] != bracket) {
      throw PatternError("'" + shown() + "' stands where '" + utf8Of({bracket}) + "' must");
    }
    ++at_;
  }

  std::string shown() const { return utf8Of({text_[at_]}); }

  std::u32string text_;
  const WordLists* lists_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::size_t lettersIn(const std::u32string& text) {
  return text.size() - static_cast<std::size_t>(std::count(text.begin(), text.end(), U' '));
}

}  // namespace

Pattern parsePattern(const std::string& text, const WordLists* lists) {
  if (text.size() > kLongestPattern) {
    throw PatternError("longer than " + std::to_string(kLongestPattern) + " bytes");
  }
  auto characters = codePointsOf(text);
  if (!characters) throw PatternError("it is not UTF-8");
  return Reader(*std::move(characters), lists).all();
}

SlotCount countSlots(const Pattern& pattern, const std::vector<std::string>& names) {
  SlotCount all;
  for (const PatternPart& part : pattern) {
    SlotCount count;
    if (!part.choices.empty()) count.least = std::numeric_limits<std::size_t>::max();
    for (const Pattern& choice : part.choices) {
      const SlotCount inner = countSlots(choice, names);
      count = {std::min(count.least, inner.least), std::max(count.most, inner.most)};
    }
    const bool counts = part.kind == Kind::kSlot &&
                        std::find(names.begin(), names.end(), utf8Of(part.text)) != names.end();
    all.least += count.least + (counts ? 1 : 0);
    all.most += count.most + (counts ? 1 : 0);
  }
  return all;
}

std::set<std::string> slotNames(const Pattern& pattern) {
  std::set<std::string> names;
  for (const PatternPart& part : pattern) {
    if (part.kind == Kind::kSlot) names.insert(utf8Of(part.text));
    for (const Pattern& choice : part.choices) names.merge(slotNames(choice));
  }
  return names;
}

std::size_t leastLetters(const Pattern& pattern) {
  std::size_t letters = 0;
  for (const PatternPart& part : pattern) {
    if (part.kind == Kind::kText) letters += lettersIn(part.text);
    std::size_t least = part.choices.empty() ? 0 : std::numeric_limits<std::size_t>::max();
    for (const Pattern& choice : part.choices) least = std::min(least, leastLetters(choice));
    letters += least;
  }
  return letters;
}

}  // namespace agrid::dialogue
