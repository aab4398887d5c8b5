// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/map_files.h"
#include "support/memory.h"

namespace agrid {
namespace {

using test::Bytes;
using test::expectImageError;
using test::rawValues;
using test::warningsOf;

std::string littleEndian(std::int64_t value, int bytes = 4) {
  std::string text;
  for (int i = 0; i < bytes; ++i, value >>= 8) text += static_cast<char>(value & 255);
  return text;
}

struct Bmp {
  std::int64_t width = 3, height = 1;
  int bits = 24;
  std::int64_t compression = 0, colours = 0;
  std::string palette, pixels;
  std::int64_t info_size = 40, offset = -1;

  std::string bytes() const {
    const auto start =
        offset >= 0 ? offset : 14 + info_size + static_cast<std::int64_t>(palette.size());
    std::string file = "BM" + std::string(8, '\0') + littleEndian(start) + littleEndian(info_size);
    if (info_size == 12) {
      return file + littleEndian(width, 2) + littleEndian(height, 2) + littleEndian(1, 2) +
             littleEndian(bits, 2) + palette + pixels;
    }
    return file + littleEndian(width) + littleEndian(height) + littleEndian(1, 2) +
           littleEndian(bits, 2) + littleEndian(compression) + std::string(12, '\0') +
           littleEndian(colours) + std::string(4, '\0') + palette + pixels;
  }
};

Bmp bmp(int bits, const std::string& palette, const std::string& pixels) {
  Bmp file;
  file.bits = bits;
  file.colours = static_cast<std::int64_t>(palette.size() / 4);
  file.palette = palette;
  file.pixels = pixels;
  return file;
}

const std::string kThreePixels("\3\3\3\1\2\6\xFF\xFF\0\0\0\0", 12);
const std::string kTwoColours("\xFF\xFF\xFF\0\0\0\0\0", 8);

TEST(MapFile, F24_BmpOf24Bits) {
  EXPECT_EQ(rawValues(bmp(24, "", kThreePixels).bytes()), (Bytes{3, 3, 170}));
  EXPECT_TRUE(warningsOf(bmp(24, "", kThreePixels).bytes()).empty());
  // the last row's filling may be missing
  EXPECT_EQ(rawValues(bmp(24, "", kThreePixels.substr(0, 9)).bytes()), (Bytes{3, 3, 170}));
}

TEST(MapFile, F24_BmpRowsRunUpUnlessTheHeightIsNegative) {
  Bmp file = bmp(24, "", std::string("\1\1\1\0\2\2\2\0", 8));
  file.width = 1;
  file.height = 2;
  EXPECT_EQ(rawValues(file.bytes()), (Bytes{1, 2}));
  file.height = -2;
  EXPECT_EQ(rawValues(file.bytes()), (Bytes{2, 1}));
}

TEST(MapFile, F24_BmpPalettesAreReadByTheirColours) {
  const std::vector<std::pair<int, std::string>> kinds = {{1, std::string("\x60\0\0\0", 4)},
                                                          {4, std::string("\x01\x10\0\0", 4)},
                                                          {8, std::string("\0\1\1\0", 4)}};
  for (const auto& [bits, pixels] : kinds) {
    const std::string file = bmp(bits, kTwoColours, pixels).bytes();
    EXPECT_EQ(rawValues(file), (Bytes{255, 0, 0})) << bits;
    ASSERT_EQ(warningsOf(file).size(), 1u);
    EXPECT_NE(warningsOf(file)[0].find("palette's indices"), std::string::npos);
  }
}

TEST(MapFile, F24_BmpPaletteOfGreysInOrder) {
  std::string greys;
  for (int i = 0; i < 256; ++i) greys += std::string(3, static_cast<char>(i)) + '\0';
  Bmp file = bmp(8, greys, std::string("\0\x80\xFF\0", 4));
  EXPECT_EQ(rawValues(file.bytes()), (Bytes{0, 128, 255}));
  EXPECT_TRUE(warningsOf(file.bytes()).empty());
  file.colours = 0;  // means all that the depth allows
  EXPECT_EQ(rawValues(file.bytes()), (Bytes{0, 128, 255}));
}

TEST(MapFile, F24_BmpOfTheOldHeader) {
  Bmp file = bmp(1, std::string("\xFF\xFF\xFF\0\0\0", 6), std::string("\x60\0\0\0", 4));
  file.info_size = 12;
  EXPECT_EQ(rawValues(file.bytes()), (Bytes{255, 0, 0}));
}

TEST(MapFile, F24_BmpOf32BitsLeavesOutTheFourthByte) {
  const std::string file = bmp(32, "", std::string("\3\3\3\0\1\2\6\xFF\xFF\xFF\0\7", 12)).bytes();
  EXPECT_EQ(rawValues(file), (Bytes{3, 3, 170}));
  EXPECT_EQ(warningsOf(file).size(), 1u);
}

TEST(MapFile, F24_BmpsThatAreRefused) {
  const auto changed = [](const auto& change) {
    Bmp file = bmp(24, "", kThreePixels);
    change(file);
    return file.bytes();
  };
  expectImageError("16 bits per pixel", changed([](Bmp& b) { b.bits = 16; }));
  expectImageError("compression", changed([](Bmp& b) { b.compression = 1; }));
  expectImageError("header of 41000", changed([](Bmp& b) { b.info_size = 41000; }));
  expectImageError("0 x 1", changed([](Bmp& b) { b.width = 0; }));
  expectImageError("both sides", changed([](Bmp& b) { b.width = -3; }));
  expectImageError("3 x 0", changed([](Bmp& b) { b.height = 0; }));
  expectImageError("overlap the header", changed([](Bmp& b) { b.offset = 53; }));
  expectImageError("need 9 bytes, the file has 0", changed([](Bmp& b) { b.offset = 4000000000; }));
  expectImageError("truncated", changed([](Bmp& b) { b.pixels.resize(8); }));
  expectImageError("truncated inside the BMP header", "BM1234567890");
  expectImageError("palette is too long", changed([](Bmp& b) {
                     b.bits = 1;
                     b.colours = 3;
                   }));
  expectImageError("palette overlaps the pixels", changed([](Bmp& b) {
                     b.bits = 4;
                     b.offset = 54;
                   }));
  expectImageError("colour 3, the palette has 2",
                   bmp(4, kTwoColours, std::string("\x01\x30\0\0", 4)).bytes());
}

TEST(MapFile, F21_HugeBmpsAreRefusedBeforeAllocation) {
  Bmp file = bmp(24, "", kThreePixels);
  const test::MemoryGrowth growth;
  file.width = file.height = 30000;
  expectImageError("truncated", file.bytes());
  file.width = 0x7FFFFFFF;
  file.height = -0x80000000ll;
  expectImageError("more than max_pixels", file.bytes());
  EXPECT_LT(growth.bytes(), 5u << 20);
}

}  // namespace
}  // namespace agrid
