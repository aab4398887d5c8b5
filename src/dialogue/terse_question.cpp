// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <utility>

#include "agrid/dialogue/relations.h"
#include "agrid/tags/name.h"

namespace agrid::dialogue {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

bool isAnything(const std::string& word) {
  return word.size() == 1 && (word == "_" || (word[0] >= 'A' && word[0] <= 'Z'));
}

std::optional<TagKind> kindOf(const std::string& word) {
  static const std::array<std::pair<const char*, TagKind>, 6> kKinds = {{
      {"area", TagKind::kArea},
      {"areas", TagKind::kArea},
      {"door", TagKind::kDoor},
      {"doors", TagKind::kDoor},
      {"object", TagKind::kObject},
      {"objects", TagKind::kObject},
  }};
  for (const auto& [name, kind] : kKinds) {
    if (word == name) return kind;
  }
  return std::nullopt;
}

void setWhat(const std::string& word, Question& question) {
  if (isAnything(word)) return;
  question.kind = kindOf(foldCase(word));
  if (!question.kind) question.what = word;
}

/// The words in parentheses: what is asked for, if it is given, and the landmark.
std::vector<std::string> argumentsIn(const std::string& rest) {
  if (rest.size() < 2 || rest.back() != ')') return {};
  const std::string inside = rest.substr(1, rest.size() - 2);
  const auto comma = inside.find(',');
  if (comma == std::string::npos) return {trimmed(inside)};
  return {trimmed(inside.substr(0, comma)), trimmed(inside.substr(comma + 1))};
}

}  // namespace

const std::vector<std::string>& relationNames() {
  static const std::vector<std::string> kNames = {
      "in",       "near",    "next_to", "nearest_to", "north_of",    "east_of",
      "south_of", "west_of", "left_of", "right_of",   "in_front_of", "behind"};
  return kNames;
}

std::optional<Question> terseQuestion(const std::string& text) {
  const std::string all = trimmed(text);
  const auto end = std::min(all.find_first_of(" ("), all.size());
  const auto& names = relationNames();
  const auto name = std::find(names.begin(), names.end(), foldCase(all.substr(0, end)));
  const std::string rest = trimmed(all.substr(end));
  if (name == names.end() || rest.empty()) return std::nullopt;
  const std::vector<std::string> arguments =
      rest.front() == '(' ? argumentsIn(rest) : std::vector<std::string>{rest};
  if (arguments.empty() || arguments.back().empty()) return std::nullopt;
  Question question;
  question.relation = static_cast<Relation>(name - names.begin());
  if (arguments.size() == 2) setWhat(arguments[0], question);
  question.place_is_robot = foldCase(arguments.back()) == "robot";
  if (!question.place_is_robot) question.place = arguments.back();
  return question;
}

}  // namespace agrid::dialogue
