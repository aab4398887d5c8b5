// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <locale>

#include <gtest/gtest.h>

#include "support/map_files.h"
#include "support/memory.h"

namespace agrid {
namespace {

using test::expectFileError;
using test::MapFolder;
using test::mapYaml;
using test::smallPgm;

void expectYamlError(const std::string& part, const std::string& yaml) {
  const MapFolder folder(smallPgm(), yaml);
  SCOPED_TRACE(yaml.substr(0, 200));
  expectFileError(FileErrorCode::kYaml, part, [&folder] { folder.load(); });
}

LoadedMap loaded(const std::string& line) { return MapFolder(smallPgm(), mapYaml(line)).load(); }

TEST(MapFile, ReadsASmallMap) {
  const LoadedMap map = MapFolder().load();
  EXPECT_EQ(map.grid.geometry.width, 3);
  EXPECT_EQ(map.grid.geometry.height, 1);
  EXPECT_EQ(map.grid.geometry.resolution, static_cast<double>(0.05f));
  EXPECT_EQ(map.grid.geometry.map_from_image.position, Point2(-1.5, 2.25));
  EXPECT_EQ(map.grid.geometry.map_from_image.yaw, 0);
  EXPECT_EQ(map.grid.values, (std::vector<std::int8_t>{0, -1, 100}));
  EXPECT_TRUE(map.warnings.empty());
}

TEST(MapFile, F3_NotOneMapping) {
  const std::string filler(70000, '#');
  expectYamlError(":1:1: longer than 65536 bytes", mapYaml() + filler);
  expectYamlError(":1:1: empty", "");
  expectYamlError(":1:1: empty", "# nothing\n  # here\n");
  expectYamlError(":2:1: not a mapping", "# c\nfive");
  expectYamlError(":1:1: not a mapping", "- image: a");
  expectYamlError(":1:1: not a mapping", "[a, b]");
  expectYamlError("second document", mapYaml() + "---\nimage: b\n");
  expectYamlError(":7:", mapYaml() + "\"open");
  expectYamlError(":2:", "image: a\n\t- b: [\n");
  expectYamlError(":4:", smallPgm());  // an image given for the YAML
}

TEST(MapFile, F4_DeepNestingAndAliases) {
  const test::MemoryGrowth growth;
  const std::string deep(30000, '[');
  expectYamlError("nested too deeply", "a: " + deep + std::string(30000, ']'));
  expectYamlError("nested too deeply", "a: " + deep);
  std::string flow = "a: ";
  for (int i = 0; i < 10000; ++i) flow += "{a: ";
  expectYamlError("nested too deeply", flow);
  std::string block;
  for (int i = 0; i < 300; ++i) block += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  expectYamlError("nested too deeply", block);
  std::string dashes = "a:\n ";
  for (int i = 0; i < 30000; ++i) dashes += "- ";
  expectYamlError("nested too deeply", dashes + "x");
  expectYamlError("longer than", "a: " + std::string(100000, '['));
  expectYamlError("aliases", "a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n");
  expectYamlError("aliases", "a: &a [*a]\n");
  EXPECT_LT(growth.bytes(), 100u << 20);
}

TEST(MapFile, F5_MissingKeys) {
  for (const std::string key :
       {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    const std::string yaml = mapYaml();
    const std::size_t line = yaml.find(key + ":");
    std::string without = yaml;
    without.erase(line, yaml.find('\n', line) + 1 - line);
    expectYamlError("'" + key + "' is missing", without);
    expectYamlError(key + " must", mapYaml(key + ":"));
  }
}

TEST(MapFile, F5_ModeIsTrinaryWhereMissing) {
  const std::string grey = "P5\n1 1\n255\n\x80";
  EXPECT_EQ(MapFolder(grey, mapYaml()).load().grid.values[0], -1);
  EXPECT_EQ(MapFolder(grey, mapYaml("mode:")).load().grid.values[0], -1);
  EXPECT_EQ(MapFolder(grey, mapYaml("mode: trinary")).load().grid.values[0], -1);
  EXPECT_EQ(MapFolder(grey, mapYaml("mode: scale")).load().grid.values[0], 66);
  EXPECT_EQ(MapFolder(grey, mapYaml("mode: raw")).load().grid.values[0], -128);
}

TEST(MapFile, F6_WrongTypes) {
  for (const std::string wrong : {"fast", "[1]", "{a: 1}", "0x10", "\"0,05\"", "1e", "0.05 m",
                                  "nan", "inf", "''", "--1", "1e400"}) {
    expectYamlError("resolution must be a number", mapYaml("resolution: " + wrong));
    expectYamlError(":2:1:", mapYaml("resolution: " + wrong));
  }
  expectYamlError("'0x10'", mapYaml("resolution: 0x10"));
  expectYamlError("origin must be", mapYaml("origin: 5"));
  expectYamlError("origin must be", mapYaml("origin: [1, 2, [3]]"));
  expectYamlError("origin must be", mapYaml("origin: [1, 2, ~]"));
  expectYamlError("origin must be", mapYaml("origin: {x: 1, y: 2, z: 3}"));
  expectYamlError("'two'", mapYaml("origin: [1, two, 3]"));
  expectYamlError("negate must be 0 or 1", mapYaml("negate: true"));
  expectYamlError("negate must be 0 or 1", mapYaml("negate: [0]"));
  expectYamlError("negate must be 0 or 1", mapYaml("negate: 1.0"));
  expectYamlError("image must be a text", mapYaml("image: [a]"));
  expectYamlError("image must be a text", mapYaml("image: ~"));
  expectYamlError("image must not be empty", mapYaml("image: ''"));
  expectYamlError("mode must be", mapYaml("mode: [raw]"));
}

TEST(MapFile, F6_NumbersMayBeQuotedAndSigned) {
  EXPECT_EQ(loaded("resolution: '0.5'").grid.geometry.resolution, 0.5);
  EXPECT_EQ(loaded("resolution: \" +5e-1 \"").grid.geometry.resolution, 0.5);
  EXPECT_EQ(loaded("resolution: .5").grid.geometry.resolution, 0.5);
  EXPECT_EQ(loaded("resolution: 1.").grid.geometry.resolution, 1);
  EXPECT_EQ(loaded("origin: ['-1', +2, 0]").grid.geometry.map_from_image.position, Point2(-1, 2));
}

TEST(MapFile, F7_OutOfRange) {
  for (const std::string wrong : {"0", "-1", "0.0009", "10.1", "1e9", "-0.0"}) {
    expectYamlError("in [0.001, 10]", mapYaml("resolution: " + wrong));
  }
  for (const std::string wrong : {".nan", ".inf"}) {
    expectYamlError("in [0.001, 10]", mapYaml("resolution: " + wrong));
  }
  expectYamlError("list of 3 numbers", mapYaml("origin: [0, 0]"));
  expectYamlError("list of 3 numbers", mapYaml("origin: [0, 0, 0, 0]"));
  expectYamlError("origin must be", mapYaml("origin: [0, 0, .nan]"));
  expectYamlError("in [-1000000, 1000000]", mapYaml("origin: [1000001, 0, 0]"));
  expectYamlError("in [-1000000, 1000000]", mapYaml("origin: [0, -1e300, 0]"));
  expectYamlError("in [-10000, 10000]", mapYaml("origin: [0, 0, 1e5]"));
  expectYamlError("in [0, 1]", mapYaml("occupied_thresh: 1.1"));
  expectYamlError("in [0, 1]", mapYaml("free_thresh: -0.1"));
  expectYamlError("less than occupied_thresh", mapYaml("free_thresh: 0.65"));
  expectYamlError("less than occupied_thresh", mapYaml("occupied_thresh: 0.1"));
  expectYamlError("0 or 1, found '2'", mapYaml("negate: 2"));
  expectYamlError("trinary, scale or raw, found 'Trinary'", mapYaml("mode: Trinary"));
}

TEST(MapFile, F8_DuplicateKeys) {
  expectYamlError("duplicate key 'resolution', first in line 2", mapYaml() + "resolution: 0.1\n");
  expectYamlError("duplicate key 'x'", mapYaml() + "x: 1\n\"x\": 2\n");
}

TEST(MapFile, F9_UnknownKeysAreWarnedOf) {
  const LoadedMap map =
      MapFolder(smallPgm(), mapYaml() + "floor: {a: [1, 2], b: x}\n? \"b\\x01\"\n: 2\n").load();
  ASSERT_EQ(map.warnings.size(), 2u);
  EXPECT_NE(map.warnings[0].find("line 7: unknown key 'floor'"), std::string::npos);
  EXPECT_NE(map.warnings[1].find("unknown key 'b\\x01'"), std::string::npos);
  expectYamlError("a key is not a scalar", mapYaml() + "? [a]\n: 1\n");
  expectYamlError("a key is missing", mapYaml() + ": 1\n");
}

TEST(MapFile, F17_CrLfAndByteOrderMarkInTheYaml) {
  std::string yaml;
  for (const char c : mapYaml()) yaml += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(MapFolder(smallPgm(), yaml).load().grid.values.size(), 3u);
  EXPECT_EQ(MapFolder(smallPgm(), "\xEF\xBB\xBF" + mapYaml()).load().grid.values.size(), 3u);
}

TEST(MapFile, NegateTurnsFreeAndOccupied) {
  EXPECT_EQ(loaded("negate: 1").grid.values, (std::vector<std::int8_t>{100, 100, 0}));
}

TEST(MapFile, YawIsWhatASubscriberGets) {
  const LoadedMap map = loaded("origin: [0, 0, 0.7]");
  EXPECT_EQ(map.orientation_z, std::sin(0.7f * 0.5f));
  EXPECT_EQ(map.orientation_w, std::cos(0.7f * 0.5f));
  EXPECT_NEAR(map.grid.geometry.map_from_image.yaw, 0.7, 2e-7);
  EXPECT_NEAR(loaded("origin: [0, 0, 6.5]").grid.geometry.map_from_image.yaw, 6.5 - 2 * M_PI, 1e-6);
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(MapFile, L13_TheLocaleDoesNotMatter) {
  const test::TemporaryFolder folder;
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const OccupancyGrid grid = loaded("resolution: 0.25").grid;
  saveMap(grid, folder.path("m.yaml"));
  const OccupancyGrid again = loadMap(folder.path("m.yaml")).grid;
  std::locale::global(before);
  EXPECT_EQ(grid.geometry.resolution, 0.25);
  EXPECT_EQ(again.geometry.resolution, 0.25);
  EXPECT_EQ(again.geometry.map_from_image.position, Point2(-1.5, 2.25));
}

}  // namespace
}  // namespace agrid
