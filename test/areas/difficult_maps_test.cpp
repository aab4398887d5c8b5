// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include <gtest/gtest.h>

#include "agrid/areas/area_segmentation.h"
#include "support/ascii_map.h"
#include "support/segmentation.h"

namespace agrid {
namespace {

using test::asciiMap;
using test::segment;

TEST(AreaMap, OfNoFreeSpaceIsEmptyAndSaysWhy) {
  for (const char c : {'#', '?'}) {
    const AreaMap areas = segment(test::asciiMap(std::vector<std::string>(5, std::string(7, c))));
    EXPECT_TRUE(areas.areas.empty());
    EXPECT_TRUE(areas.doors.empty());
    ASSERT_EQ(areas.warnings.size(), 1U);
    EXPECT_NE(areas.warnings[0].find("no free pixel"), std::string::npos);
    EXPECT_EQ(areas.pixel_labels, std::vector<std::uint16_t>(35, 0));
  }
}

TEST(AreaMap, OfSmallIslandsOnlyIsEmptyAndSaysWhy) {
  const AreaMap areas = segment(test::asciiMap({"#####", "#.#.#", "#####"}, 0.05));
  EXPECT_TRUE(areas.areas.empty());
  ASSERT_EQ(areas.warnings.size(), 1U);
  EXPECT_NE(areas.warnings[0].find("min_island_size"), std::string::npos);
}

TEST(AreaMap, LeavesOutRaysThatNothingCanEnter) {
  std::vector<std::string> rows(40, std::string(90, '?'));
  for (std::size_t y = 5; y < 35; ++y) rows[y].replace(5, 30, std::string(30, '.'));
  rows[10].replace(36, 50, std::string(50, '.'));  // 2.5 m long, beside the room
  rows[11] = rows[12] = rows[10];
  const OccupancyMap map = test::asciiMap(rows, 0.05);
  EXPECT_EQ(segment(map).areas.size(), 1U);
  AreaParams params;
  params.min_area_clearance = 0;
  EXPECT_EQ(segment(map, {}, params).areas.size(), 2U);
}

TEST(AreaMap, OfFreeSpaceOnlyIsOneArea) {
  const OccupancyMap map = test::asciiMap(std::vector<std::string>(9, std::string(13, '.')));
  const AreaMap areas = segment(map);
  ASSERT_EQ(areas.areas.size(), 1U);
  EXPECT_EQ(areas.areas[0].outline_map.size(), 4U);
  EXPECT_DOUBLE_EQ(areas.areas[0].size, 9 * 13);
  EXPECT_DOUBLE_EQ(areas.areas[0].anchor_clearance, 4.5) << "beyond the map is no free space";
}

TEST(AreaMap, OfOnePixelIsOneAreaIfItIsFree) {
  EXPECT_EQ(segment(test::asciiMap({"."})).areas.size(), 1U);
  EXPECT_TRUE(segment(test::asciiMap({"#"})).areas.empty());
}

TEST(AreaMap, M17_OfACheckerboardIsOneArea) {
  std::vector<std::string> rows;
  for (int y = 0; y < 40; ++y) {
    rows.emplace_back();
    for (int x = 0; x < 50; ++x) rows.back() += (x + y) % 2 == 0 ? '.' : '#';
  }
  EXPECT_EQ(segment(test::asciiMap(rows)).areas.size(), 1U);
}

TEST(AreaMap, M17_OfACorridorOfOnePixelIsOneArea) {
  std::vector<std::string> rows(41, std::string(60, '#'));
  for (std::size_t y = 1; y < 40; ++y) {
    if (y % 4 == 1) rows[y] = "#" + std::string(58, '.') + "#";
    if (y % 4 == 3) rows[y] = rows[y - 2];
    if (y % 4 == 2) rows[y][58] = '.';
    if (y % 4 == 0) rows[y][1] = '.';
  }
  const AreaMap areas = segment(test::asciiMap(rows, 0.2));
  ASSERT_EQ(areas.areas.size(), 1U);
  EXPECT_TRUE(areas.doors.empty());
}

TEST(AreaMap, KeepsTheLargestOfMoreAreasThanALabelCanCount) {
  AreaParams params;
  params.min_island_size = params.min_area_size = 0;
  std::vector<std::string> rows;
  for (int y = 0; y < 1024; ++y) {
    rows.emplace_back();
    for (int x = 0; x < 260; ++x) rows.back() += x % 2 == 1 && y % 2 == 1 ? '.' : '#';
  }
  rows[1023][258] = '.';  // joins two of 512 * 130 in the last corner
  const AreaMap areas = segment(test::asciiMap(rows), {}, params);
  EXPECT_EQ(areas.areas.size(), 65535U);
  ASSERT_EQ(areas.warnings.size(), 1U);
  EXPECT_NE(areas.warnings[0].find("66559 areas the 1024 smallest are left out"),
            std::string::npos);
  EXPECT_EQ(std::count_if(areas.areas.begin(), areas.areas.end(),
                          [](const Area& area) { return area.size > 1; }),
            1);
}

TEST(AreaMap, ChairLegsDoNotPartARoomAndAnchorsKeepClearOfThem) {
  std::vector<std::string> rows(60, "#" + std::string(80, '.') + "#");
  rows.front() = rows.back() = std::string(82, '#');
  for (const std::size_t y : {14U, 22U, 30U, 38U, 46U}) {
    for (std::size_t x = 8; x < 76; x += 8) rows[y][x] = '#';
  }
  const OccupancyMap map = asciiMap(rows, 0.05);
  const AreaMap areas = segment(map);
  ASSERT_EQ(areas.areas.size(), 1U);
  const Point2 anchor = areas.areas[0].anchor_map;
  double nearest = 1e9;
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    if (map.pixels()[i] == Occupancy::kFree) continue;
    const Point2 to_leg = (map.geometry().center(map.geometry().pixel(i)) - anchor).cwiseAbs();
    nearest = std::min(nearest, to_leg.norm());
  }
  EXPECT_GT(nearest, 0.25);
  EXPECT_NEAR(areas.areas[0].anchor_clearance, nearest - 0.025, 1e-6);
}

}  // namespace
}  // namespace agrid
