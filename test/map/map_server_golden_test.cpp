// SPDX-License-Identifier: BSD-3-Clause
// What the real map_server made of small images, case by case.
#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

struct GoldenCase {
  std::string image, mode, negate;
  int width = 0, height = 0;
  float z = 0, w = 0, resolution = 0;
  std::vector<std::int8_t> values;
  std::string yaw = "0.7", occupied_thresh = "0.65", free_thresh = "0.196";
};

std::string afterEquals(const std::string& word) { return word.substr(word.find('=') + 1); }

GoldenCase parsedCase(const std::string& header, std::istream& in) {
  GoldenCase golden;
  std::string negate, bytes, mask, size, z, w, resolution;
  std::istringstream words(header);
  words >> golden.image >> golden.mode >> negate >> bytes >> mask >> size >> z >> w >> resolution;
  golden.negate = afterEquals(negate);
  golden.width = std::stoi(size);
  golden.height = std::stoi(size.substr(size.find('x') + 1));
  golden.z = std::stof(afterEquals(z));
  golden.w = std::stof(w);
  golden.resolution = std::stof(afterEquals(resolution));
  for (int i = 0, value = 0; i < golden.width * golden.height && in >> value; ++i) {
    golden.values.push_back(static_cast<std::int8_t>(value));
  }
  return golden;
}

std::vector<GoldenCase> goldenCases(const std::string& path) {
  std::ifstream file(path);
  std::vector<GoldenCase> cases;
  for (std::string line; std::getline(file, line);) {
    if (line.find(" neg=") == std::string::npos) continue;
    cases.push_back(parsedCase(line, file));
  }
  if (cases.size() < 11) return cases;
  // The last cases vary what their headers do not tell.
  GoldenCase* last = cases.data() + cases.size() - 11;
  for (const char* yaw :
       {"0", "0.7", "-0.7", "3.14159265358979", "-3.14159265358979", "1.5707963", "6.5", ".nan"}) {
    (last++)->yaw = yaw;
  }
  for (GoldenCase* inverted : {last, last + 1}) {
    inverted->occupied_thresh = "0.2";
    inverted->free_thresh = "0.65";
  }
  last[2].occupied_thresh = "1.0";
  last[2].free_thresh = "0.0";
  return cases;
}

LoadedMap load(const GoldenCase& golden, const test::TemporaryFolder& folder) {
  return loadMap(folder.write(
      "map.yaml", "image: " AGRID_SHARED "/maps/map_server_golden/" + golden.image +
                      "\nresolution: 0.05\norigin: [-1.5, 2.25, " + golden.yaw + "]\nnegate: " +
                      golden.negate + "\noccupied_thresh: " + golden.occupied_thresh +
                      "\nfree_thresh: " + golden.free_thresh + "\nmode: " + golden.mode + "\n"));
}

class MapServerGolden : public testing::Test {
 protected:
  void SetUp() override {
    const std::string path = AGRID_SHARED "/maps/map_server_golden/golden.txt";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
    cases_ = goldenCases(path);
    ASSERT_GT(cases_.size(), 100u);
  }

  std::vector<GoldenCase> cases_;
  const test::TemporaryFolder folder_;
  // Read by their colours here and by their indices there, or refused here.
  const std::set<std::string> by_colour_ = {"pal8.png", "pal1.png", "p4.pbm"};
};

TEST_F(MapServerGolden, ValuesAndGeometryAreEqual) {
  std::size_t compared = 0;
  for (const GoldenCase& golden : cases_) {
    if (by_colour_.count(golden.image) != 0 || golden.yaw == ".nan" ||
        golden.occupied_thresh < golden.free_thresh) {
      continue;
    }
    const LoadedMap map = load(golden, folder_);
    SCOPED_TRACE(golden.image + " " + golden.mode + " negate " + golden.negate);
    EXPECT_EQ(map.grid.geometry.width, golden.width);
    EXPECT_EQ(map.grid.geometry.height, golden.height);
    EXPECT_EQ(map.grid.geometry.resolution, static_cast<double>(golden.resolution));
    EXPECT_EQ(map.grid.geometry.map_from_image.position, Point2(-1.5, 2.25));
    EXPECT_EQ(map.orientation_z, golden.z) << golden.yaw;
    EXPECT_EQ(map.orientation_w, golden.w) << golden.yaw;
    EXPECT_EQ(map.grid.values, golden.values);
    ++compared;
  }
  EXPECT_GT(compared, 100u);
}

TEST_F(MapServerGolden, WhatIsReadByItsColoursIsWarnedOf) {
  for (const GoldenCase& golden : cases_) {
    if (by_colour_.count(golden.image) == 0) continue;
    const LoadedMap map = load(golden, folder_);
    ASSERT_FALSE(map.warnings.empty()) << golden.image;
    EXPECT_NE(map.warnings[0].find("map_server takes"), std::string::npos) << map.warnings[0];
    EXPECT_NE(map.grid.values, golden.values) << golden.image;
  }
}

TEST_F(MapServerGolden, WhatARowOfTheRulesRefusesIsRefused) {
  int refused = 0;
  for (const GoldenCase& golden : cases_) {
    if (golden.yaw != ".nan" && golden.occupied_thresh > golden.free_thresh) continue;
    EXPECT_THROW(load(golden, folder_), FileError);
    ++refused;
  }
  EXPECT_EQ(refused, 3);
}

TEST_F(MapServerGolden, FilesThatMapServerRefusesAreRefused) {
  for (const char* image : {"nothere.png", "trunc.pgm", "max65535.pgm"}) {
    GoldenCase golden = cases_[0];
    golden.image = image;
    EXPECT_THROW(load(golden, folder_), FileError) << image;
  }
}

}  // namespace
}  // namespace agrid
