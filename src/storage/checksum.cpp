// SPDX-License-Identifier: BSD-3-Clause
#include "storage/checksum.h"

#include <array>
#include <charconv>

namespace agrid {
namespace {

constexpr std::uint64_t kPolynomial = 0xC96C5795D7870F42u;  // ECMA-182, bits reversed

std::array<std::uint64_t, 256> makeTable() {
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    std::uint64_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? kPolynomial : 0);
    table[byte] = value;
  }
  return table;
}

const std::array<std::uint64_t, 256>& table() {
  static const std::array<std::uint64_t, 256> made = makeTable();
  return made;
}

}  // namespace

std::uint64_t checksumOf(std::string_view text) {
  const auto& of_byte = table();
  std::uint64_t value = ~std::uint64_t{0};
  for (const char c : text) {
    value = of_byte[(value ^ static_cast<unsigned char>(c)) & 255] ^ (value >> 8);
  }
  return ~value;
}

// The code is linear: what a flipped bit changes depends only on its distance from the end.
std::optional<std::size_t> flippedByte(std::string_view text, std::uint64_t former_checksum) {
  const std::uint64_t difference = checksumOf(text) ^ former_checksum;
  std::uint64_t of_flip = kPolynomial;  // of the last byte's highest bit
  for (std::size_t i = text.size(); i-- > 0;) {
    for (int bit = 0; bit < 8; ++bit) {
      if (of_flip == difference) return i;
      of_flip = (of_flip >> 1) ^ (of_flip & 1 ? kPolynomial : 0);
    }
  }
  return std::nullopt;
}

std::string hexadecimalOf(std::uint64_t value) {
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4) {
    *digit = "0123456789abcdef"[value & 15];
  }
  return text;
}

std::optional<std::uint64_t> valueOfHexadecimal(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 16 || error != std::errc() || end != digits.data() + digits.size() ||
      hexadecimalOf(value) != digits) {
    return std::nullopt;
  }
  return value;
}

}  // namespace agrid
