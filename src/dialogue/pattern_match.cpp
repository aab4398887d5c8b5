// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/pattern_match.h"

#include <algorithm>
#include <utility>

namespace agrid::dialogue {
namespace {

using Kind = PatternPart::Kind;

constexpr std::size_t kMostSteps = 300000;  // for a sentence

}  // namespace

PatternMatcher::PatternMatcher(
    const Sentence& sentence,
    std::function<bool(const std::u32string&, const std::u32string&)> accepts)
    : sentence_(sentence), accepts_(std::move(accepts)) {}

std::optional<Fit> PatternMatcher::fit(const Pattern& pattern) {
  best_.reset();
  follow(pattern, 0, 0, [this](std::size_t at) { keepIfBetter(at); });
  return std::exchange(best_, std::nullopt);
}

void PatternMatcher::follow(const Pattern& pattern, std::size_t index, std::size_t at,
                            const Next& next) {
  if (++steps_ > kMostSteps) return;
  if (index == pattern.size()) return next(at);
  const PatternPart& part = pattern[index];
  const Next rest = [&](std::size_t end) { follow(pattern, index + 1, end, next); };
  if (part.kind == Kind::kText) {
    const auto end = afterText(part.text, at);
    if (!end) return;
    const std::size_t before = letters_;
    for (std::size_t i = at; i < *end; ++i) letters_ += sentence_.folded[i] == ' ' ? 0 : 1;
    rest(*end);
    letters_ = before;
  } else if (part.kind == Kind::kAny) {
    for (std::size_t end = at + 1; end <= sentence_.folded.size(); ++end) rest(end);
  } else {
    const Next filled = [&](std::size_t end) { fill(part.text, at, end, rest); };
    for (const Pattern& choice : part.choices) {
      follow(choice, 0, at, part.kind == Kind::kSlot ? filled : rest);
    }
  }
}

void PatternMatcher::fill(const std::u32string& name, std::size_t begin, std::size_t end,
                          const Next& next) {
  const std::u32string text = words(begin, end);
  if (text.empty() || !accepts_(name, text)) return;
  filled_.push_back({&name, begin, end});
  next(end);
  filled_.pop_back();
}

/// A space of a pattern is one of the sentence, or the one before, or the sentence's beginning or
/// end: what is optional may stand between two of them.
std::optional<std::size_t> PatternMatcher::afterText(const std::u32string& text,
                                                     std::size_t at) const {
  const std::u32string& said = sentence_.folded;
  for (const char32_t c : text) {
    const bool is_gap = at == 0 || at == said.size() || said[at - 1] == ' ';
    if (c == ' ' && is_gap) continue;
    if (at == said.size() || said[at] != c) return std::nullopt;
    ++at;
  }
  return at;
}

std::u32string PatternMatcher::words(std::size_t begin, std::size_t end) const {
  const std::u32string& said = sentence_.as_said;
  while (begin < end && said[begin] == ' ') ++begin;
  while (begin < end && said[end - 1] == ' ') --end;
  return said.substr(begin, end - begin);
}

void PatternMatcher::keepIfBetter(std::size_t at) {
  if (at != sentence_.folded.size() || (best_ && best_->letters >= letters_)) return;
  best_ = Fit{letters_, {}};
  for (const Filled& slot : filled_) {
    best_->slots[utf8Of(*slot.name)] = utf8Of(words(slot.begin, slot.end));
  }
}

}  // namespace agrid::dialogue
