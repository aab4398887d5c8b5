// SPDX-License-Identifier: BSD-3-Clause
#include "map/printable.h"

#include <cstddef>

namespace agrid {
namespace {

unsigned char byteAt(const std::string& text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// Length of the UTF-8 sequence at i; 0 if there is none (RFC 3629, table in section 4).
std::size_t sequenceLength(const std::string& text, std::size_t i) {
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

bool isControl(const std::string& text, std::size_t i) {
  const unsigned char first = byteAt(text, i);
  const bool c1 = first == 0xC2 && byteAt(text, i + 1) < 0xA0;  // U+0080 to U+009F
  return first < 0x20 || first == 0x7F || c1;
}

}  // namespace

std::string printable(const std::string& text) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = isControl(text, i) ? 0 : sequenceLength(text, i);
    if (length == 0) {
      const unsigned char byte = byteAt(text, i++);
      result += std::string("\\x") + kDigits[byte >> 4] + kDigits[byte & 15];
      continue;
    }
    result.append(text, i, length);
    i += length;
  }
  return result;
}

}  // namespace agrid
