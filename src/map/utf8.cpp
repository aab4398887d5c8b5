// SPDX-License-Identifier: BSD-3-Clause
#include "map/utf8.h"

namespace agrid {
namespace {

unsigned char byteAt(const std::string& text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

char byteOf(char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); }

}  // namespace

std::size_t sequenceLength(const std::string& text, std::size_t i) {
  if (i >= text.size()) return 0;
  const unsigned char first = byteAt(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byteAt(text, i + k) & 0xC0) != 0x80) return 0;
  }
  const unsigned char second = byteAt(text, i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool not_a_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return overlong || not_a_character ? 0 : length;
}

std::optional<std::u32string> codePointsOf(const std::string& text) {
  std::u32string code_points;
  code_points.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequenceLength(text, i);
    if (length == 0) return std::nullopt;
    const char32_t first = byteAt(text, i);
    char32_t code_point = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
      code_point = code_point << 6 | (byteAt(text, i + k) & 0x3FU);
    }
    code_points.push_back(code_point);
    i += length;
  }
  return code_points;
}

void appendUtf8(std::string& text, char32_t c) {
  if (c < 0x80) {
    text += byteOf(c);
    return;
  }
  if (c < 0x800) {
    text += byteOf(0xC0 | c >> 6);
  } else {
    if (c < 0x10000) {
      text += byteOf(0xE0 | c >> 12);
    } else {
      text += byteOf(0xF0 | c >> 18);
      text += byteOf(0x80 | (c >> 12 & 0x3F));
    }
    text += byteOf(0x80 | (c >> 6 & 0x3F));
  }
  text += byteOf(0x80 | (c & 0x3F));
}

}  // namespace agrid
