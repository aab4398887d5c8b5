// SPDX-License-Identifier: BSD-3-Clause
#include "tools/tag_sentences.h"

#include <algorithm>
#include <tuple>

#include "map/printable.h"

namespace agrid::tools {

std::string numbered(const Tag& tag) {
  const std::string& name = nameOf(tag);
  return std::to_string(idOf(tag)) + (name.empty() ? "" : " '" + name + "'");
}

std::string described(const Tag& tag) {
  static const char* const kKinds[] = {"area ", "door ", "object "};
  return kKinds[tag.index()] + numbered(tag);
}

std::string enumerated(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

void Sentences::addOn(const Tag& tag, const std::string& sentence) {
  all_.push_back({static_cast<int>(kindOf(tag)), idOf(tag), sentence});
}

void Sentences::say(const Tag& tag, const std::string& predicate) {
  addOn(tag, described(tag) + " " + predicate);
}

std::vector<std::string> Sentences::lines() const {
  std::vector<Sentence> sorted = all_;
  std::sort(sorted.begin(), sorted.end(), [](const Sentence& a, const Sentence& b) {
    return std::tie(a.kind, a.id, a.text) < std::tie(b.kind, b.id, b.text);
  });
  std::vector<std::string> lines;
  for (const Sentence& sentence : sorted) lines.push_back(printable(sentence.text));
  return lines;
}

}  // namespace agrid::tools
