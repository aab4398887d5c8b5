// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "dialogue/pattern.h"

namespace agrid::dialogue {

/// How a sentence fits a pattern.
struct Fit {
  std::size_t letters = 0;  ///< of the sentence that are the pattern's own, without the spaces
  Slots slots;              ///< as they were said
};

/// Looks how sentences fit patterns, with an end to how long it looks.
class PatternMatcher {
 public:
  /// @param accepts  whether a slot (name) can have a text
  PatternMatcher(const Sentence& sentence,
                 std::function<bool(const std::u32string&, const std::u32string&)> accepts);

  /// The fit with the most letters of the pattern; of equal ones, that whose first slots are the
  /// shortest. Nothing if the sentence does not fit, or if too much was tried for it already.
  std::optional<Fit> fit(const Pattern& pattern);

 private:
  using Next = std::function<void(std::size_t)>;
  struct Filled {
    const std::u32string* name;
    std::size_t begin;
    std::size_t end;
  };

  void follow(const Pattern& pattern, std::size_t part, std::size_t at, const Next& next);
  void fill(const std::u32string& name, std::size_t begin, std::size_t end, const Next& next);
  std::optional<std::size_t> afterText(const std::u32string& text, std::size_t at) const;
  std::u32string words(std::size_t begin, std::size_t end) const;
  void keepIfBetter(std::size_t at);

  const Sentence& sentence_;
  std::function<bool(const std::u32string&, const std::u32string&)> accepts_;
  std::size_t steps_ = 0;
  std::size_t letters_ = 0;  ///< on the way that is being tried
  std::vector<Filled> filled_;
  std::optional<Fit> best_;
};

}  // namespace agrid::dialogue
