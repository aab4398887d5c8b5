// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace agrid::test {

enum class PngColour { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6 };

inline std::string bigEndian(std::uint32_t value) {
  std::string bytes(4, '\0');
  for (int i = 3; i >= 0; --i, value >>= 8) {
    bytes[static_cast<std::size_t>(i)] = static_cast<char>(value & 255);
  }
  return bytes;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : type + data) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0);
  }
  return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(~crc);
}

/// A zlib stream without compression.
inline std::string stored(const std::string& data) {
  std::string stream = "\x78\x01";
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  std::size_t i = 0;
  do {
    const std::size_t count = std::min<std::size_t>(data.size() - i, 65535);
    stream += static_cast<char>(i + count == data.size() ? 1 : 0);
    for (const std::size_t part : {count, ~count}) {
      stream += static_cast<char>(part & 255);
      stream += static_cast<char>(part >> 8 & 255);
    }
    stream += data.substr(i, count);
    i += count;
  } while (i < data.size());
  for (const char c : data) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return stream + bigEndian(b << 16 | a);
}

/// What a PNG file holds; `rows` are the packed samples of each row.
struct PngFile {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  int bit_depth = 8;
  PngColour colour = PngColour::kGrey;
  std::vector<std::string> rows;
  std::string chunks;       ///< between IHDR and IDAT
  bool interlaced = false;  ///< only with 8-bit grey: one byte per pixel

  std::string bytes() const { return start() + pngChunk("IDAT", stored(scanLines())) + end(); }
  std::string start() const {
    return "\x89PNG\r\n\x1A\n" +
           pngChunk("IHDR", bigEndian(width) + bigEndian(height) + static_cast<char>(bit_depth) +
                                static_cast<char>(colour) + std::string(2, '\0') +
                                static_cast<char>(interlaced ? 1 : 0)) +
           chunks;
  }
  static std::string end() { return pngChunk("IEND", ""); }

  std::string scanLines() const {
    std::string lines;
    if (!interlaced) {
      for (const std::string& row : rows) lines += '\0' + row;
      return lines;
    }
    struct Pass {
      std::size_t x, y, step_x, step_y;
    };
    for (const Pass p : {Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8}, Pass{2, 0, 4, 4},
                         Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2}, Pass{0, 1, 1, 2}}) {
      for (std::size_t y = p.y; y < height && p.x < width; y += p.step_y) {
        lines += '\0';
        for (std::size_t x = p.x; x < width; x += p.step_x) lines += rows[y][x];
      }
    }
    return lines;
  }
};

}  // namespace agrid::test
