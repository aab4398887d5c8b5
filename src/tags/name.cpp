// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/name.h"

#include <algorithm>

#include "map/printable.h"
#include "map/utf8.h"
#include "tags/letter_case.h"

namespace agrid {
namespace {

constexpr std::size_t kLongestName = 256;  // bytes
constexpr std::size_t kLongestShown = 64;  // bytes

bool isIn(char32_t c, char32_t first, char32_t last) { return first <= c && c <= last; }

bool breaksTheLine(char32_t c) {
  return c < 0x20 || isIn(c, 0x7F, 0x9F) || isIn(c, 0x2028, 0x2029);
}

/// Whether the text after it is shown in another order than it is stored.
bool changesDirection(char32_t c) { return isIn(c, 0x202A, 0x202E) || isIn(c, 0x2066, 0x2069); }

bool isInvisible(char32_t c) {
  return c == ' ' || c == 0xA0 || c == 0xAD || c == 0x1680 || isIn(c, 0x2000, 0x200F) ||
         c == 0x202F || isIn(c, 0x205F, 0x2064) || c == 0x3000 || c == 0xFEFF;
}

/// The beginning of a text, fit for a message.
std::string shown(const std::string& text) {
  std::size_t end = std::min(text.size(), kLongestShown);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;
  }
  std::string result;
  const std::string beginning = printable(text.substr(0, end));
  for (const char32_t c : codePointsOf(beginning).value_or(std::u32string())) {
    if (!changesDirection(c) && !breaksTheLine(c)) appendUtf8(result, c);
  }
  return "'" + result + (end < text.size() ? "..." : "") + "'";
}

}  // namespace

std::string problemOfName(const std::string& name) {
  if (name.empty()) return "a name must not be empty";
  if (name.size() > kLongestName) {
    return "the name " + shown(name) + " has " + std::to_string(name.size()) +
           " bytes, allowed are 1 to " + std::to_string(kLongestName);
  }
  const auto code_points = codePointsOf(name);
  if (!code_points) return "the name " + shown(name) + " is not UTF-8";
  const auto has = [&](bool (*property)(char32_t)) {
    return std::any_of(code_points->begin(), code_points->end(), property);
  };
  if (has(breaksTheLine)) {
    return "the name " + shown(name) + " holds a control character or a line break";
  }
  if (has(changesDirection)) {
    return "the name " + shown(name) + " holds a character that changes the writing direction";
  }
  if (std::all_of(code_points->begin(), code_points->end(), isInvisible)) {
    return "the name " + shown(name) + " holds nothing but spaces";
  }
  return {};
}

std::string foldCase(const std::string& text) {
  const auto code_points = codePointsOf(text);
  std::string folded;
  folded.reserve(text.size());
  if (code_points) {
    for (const char32_t c : *code_points) appendUtf8(folded, smallLetter(c));
    return folded;
  }
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    folded += byte < 0x80 ? static_cast<char>(smallLetter(byte)) : c;
  }
  return folded;
}

}  // namespace agrid
