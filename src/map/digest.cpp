// SPDX-License-Identifier: BSD-3-Clause
#include "map/digest.h"

#include <cstddef>
#include <cstring>

namespace agrid {
namespace {

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87u;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4Fu;

std::uint64_t rotated(std::uint64_t value, int bits) {
  return (value << bits) | (value >> (64 - bits));
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  return rotated(hash ^ (rotated(word * kPrime2, 31) * kPrime1), 27) * kPrime1 + kPrime2;
}

std::uint64_t bitsOf(double value) {
  const double positive_zero = value + 0.0;  // the two zeros are the same place
  std::uint64_t bits = 0;
  std::memcpy(&bits, &positive_zero, sizeof bits);
  return bits;
}

std::uint64_t wordOf(const Occupancy* pixels, std::size_t count) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < count; ++i) {
    word |= static_cast<std::uint64_t>(pixels[i]) << (8 * i);
  }
  return word;
}

// Without it, a change in the last words would reach only some of the digits.
std::uint64_t avalanched(std::uint64_t hash) {
  hash = (hash ^ (hash >> 33)) * kPrime2;
  hash = (hash ^ (hash >> 29)) * kPrime1;
  return hash ^ (hash >> 32);
}

std::string hexadecimal(std::uint64_t value) {
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4) {
    *digit = "0123456789abcdef"[value & 15];
  }
  return text;
}

}  // namespace

std::string mapDigest(const MapGeometry& geometry, const std::vector<Occupancy>& pixels) {
  std::uint64_t hash = kPrime1;
  hash = mixed(hash, static_cast<std::uint64_t>(geometry.width));
  hash = mixed(hash, static_cast<std::uint64_t>(geometry.height));
  hash = mixed(hash, bitsOf(geometry.resolution));
  hash = mixed(hash, bitsOf(geometry.map_from_image.position.x()));
  hash = mixed(hash, bitsOf(geometry.map_from_image.position.y()));
  hash = mixed(hash, bitsOf(geometry.map_from_image.yaw));
  std::size_t i = 0;
  for (; i + 8 <= pixels.size(); i += 8) hash = mixed(hash, wordOf(pixels.data() + i, 8));
  hash = mixed(hash, wordOf(pixels.data() + i, pixels.size() - i));
  return hexadecimal(avalanched(hash));
}

}  // namespace agrid
