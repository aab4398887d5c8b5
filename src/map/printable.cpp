// SPDX-License-Identifier: BSD-3-Clause
#include "map/printable.h"

#include <cstddef>

#include "map/utf8.h"

namespace agrid {
namespace {

unsigned char byteAt(const std::string& text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
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
