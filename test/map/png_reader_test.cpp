// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <gtest/gtest.h>

#include "support/map_files.h"
#include "support/memory.h"
#include "support/png_file.h"

namespace agrid {
namespace {

using test::Bytes;
using test::expectImageError;
using test::MapFolder;
using test::mapYaml;
using test::pngChunk;
using test::PngColour;
using test::PngFile;
using test::rawValues;
using test::warningsOf;

PngFile oneRow(PngColour colour, int bit_depth, std::uint32_t width, const std::string& row) {
  PngFile png;
  png.width = width;
  png.bit_depth = bit_depth;
  png.colour = colour;
  png.rows = {row};
  return png;
}

PngFile grey(const std::string& row) {
  return oneRow(PngColour::kGrey, 8, static_cast<std::uint32_t>(row.size()), row);
}

std::vector<std::int8_t> valuesIn(const std::string& mode, const PngFile& png) {
  return MapFolder(png.bytes(), mapYaml("mode: " + mode)).load().grid.values;
}

TEST(MapFile, F25_GreyOfAnyDepth) {
  PngFile two_rows = grey("\1\2\3");
  two_rows.height = 2;
  two_rows.rows.push_back("\4\5\6");
  EXPECT_EQ(rawValues(two_rows.bytes()), (Bytes{4, 5, 6, 1, 2, 3}));
  EXPECT_TRUE(warningsOf(two_rows.bytes()).empty());
  EXPECT_EQ(rawValues(oneRow(PngColour::kGrey, 1, 3, "\xA0").bytes()), (Bytes{255, 0, 255}));
  EXPECT_EQ(rawValues(oneRow(PngColour::kGrey, 2, 4, "\x1B").bytes()), (Bytes{0, 85, 170, 255}));
  EXPECT_EQ(rawValues(oneRow(PngColour::kGrey, 4, 3, "\x0F\x30").bytes()), (Bytes{0, 255, 51}));
}

TEST(MapFile, AnOpaqueTransparencyCountsAsAColourUnlessSkipped) {
  MapFileParams by_colours;
  by_colours.skip_opaque_alpha = true;
  const auto values = [](const std::string& rgba, const MapFileParams& params) {
    const MapFolder folder(oneRow(PngColour::kRgba, 8, 2, rgba).bytes());
    return loadMap(folder.path("map.yaml"), params).grid.values;
  };
  const std::string opaque = "\xCD\xCD\xCD\xFF\x50\x50\x50\xFF";
  EXPECT_EQ(values(opaque, {}), (std::vector<std::int8_t>{0, -1}));
  EXPECT_EQ(values(opaque, by_colours), (std::vector<std::int8_t>{-1, 100}));
  const std::string translucent = "\xCD\xCD\xCD\xFE\x50\x50\x50\xFF";
  EXPECT_EQ(values(translucent, by_colours), values(translucent, {}));
}

TEST(MapFile, F19_SixteenBitPngKeepsItsHighBytes) {
  const std::string png = oneRow(PngColour::kGrey, 16, 2, "\x12\xFF\xCD\x80").bytes();
  EXPECT_EQ(rawValues(png), (Bytes{0x12, 0xCD}));
  ASSERT_EQ(warningsOf(png).size(), 1u);
  EXPECT_NE(warningsOf(png)[0].find("high bytes"), std::string::npos);
}

TEST(MapFile, F25_Interlaced) {
  PngFile png;
  png.width = 11;
  png.height = 10;
  png.interlaced = true;
  Bytes expected;
  for (int y = 0; y < 10; ++y) {
    png.rows.emplace_back();
    for (int x = 0; x < 11; ++x) png.rows.back() += static_cast<char>(20 * y + x);
  }
  for (auto row = png.rows.rbegin(); row != png.rows.rend(); ++row) {
    expected.insert(expected.end(), row->begin(), row->end());
  }
  EXPECT_EQ(rawValues(png.bytes()), expected);
}

TEST(MapFile, F25_ColoursAreAveraged) {
  EXPECT_EQ(rawValues(oneRow(PngColour::kRgb, 8, 2, "\1\2\6\xFF\xFF\x0A").bytes()),
            (Bytes{3, 173}));
}

TEST(MapFile, F25_TransparencyCountsInTrinaryModeAndIsUnknownInScaleMode) {
  // white opaque, white transparent, grey opaque, grey transparent
  const std::string row("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\0\x70\x70\x70\xFF\x70\x70\x70\0", 16);
  const PngFile rgba = oneRow(PngColour::kRgba, 8, 4, row);
  EXPECT_EQ(valuesIn("trinary", rgba), (std::vector<std::int8_t>{0, -1, -1, 100}));
  EXPECT_EQ(valuesIn("scale", rgba), (std::vector<std::int8_t>{0, 0, 79, -1}));
  EXPECT_EQ(valuesIn("raw", rgba), (std::vector<std::int8_t>{-1, -1, 112, 112}));
  const std::string short_row("\xFF\xFF\xFF\0\x70\xFF\x70\0", 8);
  for (const std::string mode : {"trinary", "scale", "raw"}) {
    EXPECT_EQ(valuesIn(mode, oneRow(PngColour::kGreyAlpha, 8, 4, short_row)), valuesIn(mode, rgba));
  }
}

TEST(MapFile, F25_PalettesAreReadByTheirColours) {
  PngFile png = oneRow(PngColour::kPalette, 2, 4, "\x1B");
  png.chunks = pngChunk("PLTE", std::string("\xFF\xFF\xFF\0\0\0\xCD\xCD\xCD\x10\x20\x30", 12));
  EXPECT_EQ(rawValues(png.bytes()), (Bytes{255, 0, 205, 32}));
  ASSERT_EQ(warningsOf(png.bytes()).size(), 1u);
  EXPECT_NE(warningsOf(png.bytes())[0].find("palette's indices"), std::string::npos);
  png.chunks += pngChunk("tRNS", std::string("\xFF\0", 2));  // one: map_server keeps the indices
  EXPECT_EQ(warningsOf(png.bytes()).size(), 1u);
  png.chunks.resize(png.chunks.size() - 14);
  png.chunks += pngChunk("tRNS", std::string("\x80\0", 2));  // map_server expands these
  EXPECT_TRUE(warningsOf(png.bytes()).empty());
}

TEST(MapFile, F25_APaletteOfGreysInOrderIsWhatMapServerTakesItFor) {
  PngFile png = oneRow(PngColour::kPalette, 8, 2, std::string("\0\2", 2));
  png.chunks = pngChunk("PLTE", std::string("\0\0\0\1\1\1\2\2\2", 9));
  EXPECT_EQ(rawValues(png.bytes()), (Bytes{0, 2}));
  EXPECT_TRUE(warningsOf(png.bytes()).empty());
}

TEST(MapFile, F25_DamagedFiles) {
  const PngFile png = grey("\1\2\3");
  const std::string bytes = png.bytes();
  for (std::size_t size : {std::size_t{8}, std::size_t{20}, bytes.size() - 25}) {
    expectImageError("PNG: ", bytes.substr(0, size));
  }
  std::string bad_crc = bytes;
  bad_crc[png.start().size() - 1] ^= 1;
  expectImageError("CRC", bad_crc);
  const std::string pixels = test::stored(png.scanLines());
  expectImageError("PNG: ", png.start() + pngChunk("IDAT", pixels.substr(0, 8)) + PngFile::end());
  expectImageError("PNG: ", png.start() + PngFile::end());
  expectImageError("PNG: ", oneRow(PngColour::kPalette, 8, 1, "x").bytes());  // no palette
  expectImageError("PNG: ", oneRow(PngColour::kRgb, 4, 1, "xxx").bytes());    // no such depth
}

TEST(MapFile, F22_DamageAfterThePixelsIsWarnedOf) {
  const PngFile png = grey("\1\2\3");
  const std::string without_end = png.bytes().substr(0, png.bytes().size() - 12);
  EXPECT_EQ(rawValues(without_end), (Bytes{1, 2, 3}));
  ASSERT_EQ(warningsOf(without_end).size(), 1u);
  EXPECT_NE(warningsOf(without_end)[0].find("damaged after the pixels"), std::string::npos);
  ASSERT_EQ(warningsOf(png.bytes() + "abcd").size(), 1u);
  EXPECT_NE(warningsOf(png.bytes() + "abcd")[0].find("4 bytes after"), std::string::npos);
}

TEST(MapFile, F25_HugeSizesAreRefusedBeforeAllocation) {
  const test::MemoryGrowth growth;
  PngFile png = grey("\1\2\3");
  png.width = 0x80000000u;
  expectImageError("PNG: ", png.bytes());
  png.width = 0x7FFFFFFFu;
  png.height = 0x7FFFFFFFu;
  expectImageError("more than max_pixels", png.bytes());
  png.width = png.height = 30000;
  expectImageError("truncated: the image declares 900000000 bytes", png.bytes());
  png.width = 0;
  expectImageError("PNG: ", png.bytes());
  png.width = 3000000;  // beyond libpng's own bound
  png.height = 1;
  png.rows = {std::string(3000000, '\xFE')};
  EXPECT_EQ(MapFolder(png.bytes()).load().grid.values.size(), 3000000u);
  EXPECT_LT(growth.bytes(), 40u << 20);
}

TEST(MapFile, F25_TextAndProfileChunksAreNotInflated) {
  PngFile png = grey("\1\2\3");
  const std::string zeros(1 << 20, '\0');
  for (int i = 0; i < 4; ++i) {
    png.chunks += pngChunk("iCCP", std::string("p\0\0", 3) + test::stored(zeros)) +
                  pngChunk("zTXt", std::string("k\0\0", 3) + test::stored(zeros)) +
                  pngChunk("tEXt", std::string("k\0", 2) + zeros);
  }
  const MapFolder folder(png.bytes(), mapYaml("mode: raw"));
  const test::MemoryGrowth growth;
  EXPECT_EQ(folder.load().grid.values, (std::vector<std::int8_t>{1, 2, 3}));
  EXPECT_LT(growth.bytes(), 2u << 20);
}

TEST(MapFile, F25_GammaIsLeftOut) {
  PngFile png = grey("\1\x80\xFE");
  png.chunks = pngChunk("gAMA", test::bigEndian(100000)) + pngChunk("sBIT", "\5");
  EXPECT_EQ(rawValues(png.bytes()), (Bytes{1, 0x80, 0xFE}));
}

TEST(MapFile, F24_APngNamedOtherwiseIsAPng) {
  EXPECT_EQ(rawValues(grey("\7").bytes()), (Bytes{7}));  // its name ends in .img
}

TEST(MapFile, F27_MemoryStaysWithinEightBytesPerPixel) {
  constexpr std::size_t kSide = 2000;
  PngFile png;
  png.width = png.height = kSide;
  png.colour = PngColour::kRgba;
  png.rows.assign(kSide, std::string(4 * kSide, '\xFF'));
  const MapFolder folder(png.bytes());
  png.rows.clear();
  const test::MemoryGrowth growth;
  EXPECT_EQ(folder.load().grid.values.size(), kSide * kSide);
  EXPECT_LT(growth.bytes(), 8 * kSide * kSide + (8u << 20));
}

}  // namespace
}  // namespace agrid
