// SPDX-License-Identifier: BSD-3-Clause
#include "semantic_map/closest_names.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "agrid/tags/name.h"
#include "map/utf8.h"

namespace agrid {
namespace {

std::u32string charactersOf(const std::string& text) {
  if (auto characters = codePointsOf(text)) return *std::move(characters);
  std::u32string bytes;
  for (const char c : text) bytes.push_back(static_cast<unsigned char>(c));
  return bytes;
}

std::size_t distanceBetween(const std::u32string& a, const std::u32string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::size_t editDistance(const std::string& a, const std::string& b) {
  return distanceBetween(charactersOf(a), charactersOf(b));
}

std::vector<std::string> closestNames(const std::string& wanted,
                                      const std::vector<std::string>& names, std::size_t count) {
  const std::u32string folded = charactersOf(foldCase(wanted));
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    ranked.emplace_back(distanceBetween(folded, charactersOf(foldCase(name))), name);
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> closest;
  for (const auto& [distance, name] : ranked) {
    if (closest.size() == count) break;
    if (closest.empty() || closest.back() != name) closest.push_back(name);
  }
  return closest;
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

}  // namespace agrid
