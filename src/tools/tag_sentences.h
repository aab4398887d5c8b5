// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid::tools {

/// How sentences call a tag: its kind, id and, in quotes, its name.
std::string described(const Tag& tag);
/// ... without its kind: "3 'kitchen'".
std::string numbered(const Tag& tag);
/// "1, 2 and 3".
std::string enumerated(const std::vector<std::string>& parts);

/// Sentences about tags, to be put in order: what is about the whole place first, then by kind and
/// id.
class Sentences {
 public:
  void addOnPlace(const std::string& sentence) { all_.push_back({0, 0, sentence}); }
  void addOn(const Tag& tag, const std::string& sentence);
  /// "area 3 'kitchen' " and what is said of it.
  void say(const Tag& tag, const std::string& predicate);
  /// In order, a line each, fit for a terminal.
  std::vector<std::string> lines() const;

 private:
  struct Sentence {
    int kind = 0;
    std::uint32_t id = 0;
    std::string text;
  };
  std::vector<Sentence> all_;
};

}  // namespace agrid::tools
