// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "support/map_files.h"
#include "support/memory.h"

namespace agrid {
namespace {

using test::Bytes;
using test::expectImageError;
using test::rawValues;
using test::warningsOf;

// Raw mode keeps every grey; the lowest row comes first.
const Bytes kTwoRows = {4, 5, 6, 1, 2, 3};
const std::string kTwoRowPixels = "\1\2\3\4\5\6";

TEST(MapFile, F15_BinaryAndAsciiGiveTheSame) {
  EXPECT_EQ(rawValues("P5\n3 2\n255\n" + kTwoRowPixels), kTwoRows);
  EXPECT_EQ(rawValues("P2\n3 2\n255\n1 2 3\n4 5 6\n"), kTwoRows);
  EXPECT_EQ(rawValues("P2\n3 2\n255\n1 2 3 4 5 6"), kTwoRows);
}

TEST(MapFile, F16_CommentsAndSpacesAnywhereInTheHeader) {
  for (const std::string header :
       {"P5#a\n#b\n3 2\n255\n", "P5 # 9 9\n 3 \t 2\v\f # c\r255\n", "P5\n3#a\n2#b\n255\n",
        "P5\n3 2\n255# c\n", "P5 3 2 255 ", "P5\n003 2 0255\n"}) {
    EXPECT_EQ(rawValues(header + kTwoRowPixels), kTwoRows) << header;
  }
  EXPECT_EQ(rawValues("P2 3 2 #x\n255 1 2 3#y\n4 #z\n5 6 # end\n"), kTwoRows);
  EXPECT_TRUE(warningsOf("P2 3 2 255 1 2 3 4 5 6 # end\n").empty());
}

TEST(MapFile, F17_CrLfInTheHeader) {
  EXPECT_EQ(rawValues("P5\r\n3 2\r\n255\n" + kTwoRowPixels), kTwoRows);
  EXPECT_TRUE(warningsOf("P5\r\n3 2\r\n255\n" + kTwoRowPixels).empty());
  EXPECT_EQ(rawValues("P2\r\n3 2\r\n255\r\n1 2 3\r\n4 5 6\r\n"), kTwoRows);
}

TEST(MapFile, F17_CrLfBeforeThePixels) {
  const std::string crlf = "P5\r\n3 2\r\n255\r\n" + kTwoRowPixels;
  EXPECT_EQ(rawValues(crlf), kTwoRows);
  ASSERT_EQ(warningsOf(crlf).size(), 1u);
  EXPECT_NE(warningsOf(crlf)[0].find("CR LF"), std::string::npos);
  expectImageError("CR LF", crlf + "x");
  expectImageError("truncated", "P5\r\n3 2\r\n255\r\n" + kTwoRowPixels.substr(0, 4));
  // One space is one byte: here the LF is the first pixel.
  EXPECT_EQ(rawValues("P5\n3 2\n255\r\n" + kTwoRowPixels.substr(1)), (Bytes{4, 5, 6, 10, 2, 3}));
  EXPECT_EQ(rawValues("P5\n3 2\n255\r" + kTwoRowPixels), kTwoRows);
}

TEST(MapFile, F18_MaxvalBelow255IsRescaled) {
  EXPECT_EQ(rawValues("P5\n3 1\n100\n" + std::string("\0\x32\x64", 3)), (Bytes{0, 127, 255}));
  EXPECT_EQ(rawValues("P5\n2 1\n1\n" + std::string("\0\1", 2)), (Bytes{0, 255}));
  EXPECT_EQ(rawValues("P5\n2 1\n254\n\x01\xFE"), (Bytes{1, 255}));
  EXPECT_EQ(rawValues("P2\n3 1\n7\n0 3 7"), (Bytes{0, 109, 255}));
  EXPECT_EQ(rawValues("P6\n1 1\n3\n" + std::string("\0\1\2", 3)), (Bytes{85}));
}

TEST(MapFile, F18_SamplesAboveMaxval) {
  const std::string odd = "P5\n2 1\n100\n\x64\x65";
  EXPECT_EQ(rawValues(odd), (Bytes{255, 1}));  // 257 modulo 256, as map_server's
  ASSERT_EQ(warningsOf(odd).size(), 1u);
  EXPECT_NE(warningsOf(odd)[0].find("1 samples exceed maxval 100"), std::string::npos);
  expectImageError("outside [0, 100]", "P2\n2 1\n100\n100 101");
  expectImageError("outside [0, 255]", "P2\n2 1\n255\n255 256");
}

TEST(MapFile, F19_SixteenBitPgmIsRefused) {
  const std::string pixels(64, '\0');
  expectImageError("maxval is 256: 16-bit samples", "P5\n4 4\n256\n" + pixels);
  expectImageError("maxval is 65535: 16-bit samples", "P2\n4 4\n65535\n" + pixels);
}

TEST(MapFile, F20_BadNumbersInTheHeader) {
  const std::string pixels(64, '\0');
  for (const std::string wrong : {"0", "65536", "999999999"}) {
    expectImageError("maxval is " + wrong, "P5\n4 4\n" + wrong + "\n" + pixels);
  }
  expectImageError("maxval is not a number", "P5\n4 4\n-1\n" + pixels);
  expectImageError("over 9 digits", "P5\n4 4\n99999999999999999999\n" + pixels);
  expectImageError("over 9 digits", "P5\n18446744073709551620 4\n255\n" + pixels);
  expectImageError("width is not a number", "P5\n-4 4\n255\n" + pixels);
  expectImageError("height is not a number", "P5\n4x4\n255\n" + pixels);
  expectImageError("no space after the header", "P5\n4 4\n255x" + pixels);
  expectImageError("width is missing", "P5");
  expectImageError("maxval is missing", "P5\n4 4\n");
  expectImageError("no space after the header", "P5\n4 4\n255");
  expectImageError("a sample is not a number", "P2\n2 1\n255\n1 -1");
}

TEST(MapFile, F21_HugeSizesAreRefusedBeforeAllocation) {
  const test::MemoryGrowth growth;
  expectImageError("over 9 digits", "P5 2147483647 2147483647 255 abc");
  expectImageError("more than max_pixels", "P5 999999999 999999999 255 abc");
  expectImageError("need 900000000 bytes, the file has 3", "P5 30000 30000 255 abc");
  expectImageError("need 900000000 bytes, the file has 3", "P1 30000 30000 111");
  expectImageError("truncated", "P2 30000 30000 255 1 2");
  expectImageError("truncated", "P6 30000 30000 255 abc");
  expectImageError("truncated", "P4 30000 30000 abc");
  EXPECT_LT(growth.bytes(), 5u << 20);
}

TEST(MapFile, F21_TheCapIsAParameter) {
  const test::MapFolder folder;  // 3 pixels
  MapFileParams params;
  params.max_pixels = 3;
  EXPECT_EQ(folder.load(params).grid.values.size(), 3u);
  params.max_pixels = 2;
  test::expectFileError(FileErrorCode::kImage, "more than max_pixels = 2",
                        [&] { folder.load(params); });
  for (const double wrong : {0.0, -1.0, 1e19, std::numeric_limits<double>::quiet_NaN()}) {
    params.max_pixels = wrong;
    EXPECT_THROW(folder.load(params), std::invalid_argument);
  }
}

TEST(MapFile, F22_TruncatedPixelsAndTrailingBytes) {
  expectImageError("need 6 bytes, the file has 5", "P5\n3 2\n255\n12345");
  expectImageError("3 of 4 samples", "P2\n4 1\n255\n100 100 100");
  expectImageError("need 2 bytes, the file has 1", "P4\n9 1\nx");
  const std::string longer = "P5\n3 2\n255\n" + kTwoRowPixels + "abc";
  EXPECT_EQ(rawValues(longer), kTwoRows);
  ASSERT_EQ(warningsOf(longer).size(), 1u);
  EXPECT_NE(warningsOf(longer)[0].find("3 bytes after the image"), std::string::npos);
  EXPECT_EQ(warningsOf("P2 1 1 255 7 8").size(), 1u);
}

TEST(MapFile, F23_EmptyImages) {
  expectImageError("0 x 0", "P5\n0 0\n255\n");
  expectImageError("0 x 3", "P5\n0 3\n255\n");
  expectImageError("3 x 0", "P2\n3 0\n255\n");
}

TEST(MapFile, F24_OtherNetpbmFormats) {
  const std::string warning = "map_server takes every pixel";
  for (const std::string& bitmap : {std::string("P1\n9 2\n10000000 1\n011111110"),
                                    "P4\n9 2\n" + std::string("\x80\x80\x7F\x00", 4)}) {
    EXPECT_EQ(rawValues(bitmap),
              (Bytes{255, 0, 0, 0, 0, 0, 0, 0, 255, 0, 255, 255, 255, 255, 255, 255, 255, 0}));
    ASSERT_EQ(warningsOf(bitmap).size(), 1u);
    EXPECT_NE(warningsOf(bitmap)[0].find(warning), std::string::npos);
  }
  expectImageError("outside [0, 1]", "P1\n2 1\n12");
  EXPECT_EQ(rawValues("P3\n2 1\n255\n1 2 3 255 255 0"), (Bytes{2, 170}));
  EXPECT_EQ(rawValues("P6\n2 1\n255\n" + std::string("\1\2\3\xFF\xFF\0", 6)), (Bytes{2, 170}));
}

TEST(MapFile, F24_OtherFormatsAreRefusedByContent) {
  expectImageError("format PAM (P7) not supported", "P7\nWIDTH 1\n");
  expectImageError("format JPEG not supported", "\xFF\xD8\xFF\xE0");
  expectImageError("format GIF not supported", "GIF89a");
  expectImageError("format TIFF not supported", std::string("II*\0", 4));
  expectImageError("format TIFF not supported", std::string("MM\0*", 4));
  expectImageError("WebP", "RIFF....WEBP");
  expectImageError("not an image", "some text");
  expectImageError("not an image", "P8\n1 1\n");
  expectImageError("not an image", "P");
  expectImageError("the file is empty", "");
}

}  // namespace
}  // namespace agrid
