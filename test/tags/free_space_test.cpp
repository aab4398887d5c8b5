// SPDX-License-Identifier: BSD-3-Clause
#include "tags/free_space.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/ascii_map.h"

namespace agrid {
namespace {

TEST(FreeSpace, LosesIslandsAndGainsClutter) {
  const OccupancyMap map = test::asciiMap(
      {
          "?????????????",
          "?#########..?",
          "?#.......#..?",
          "?#..##...####",
          "?#..#....#?.#",
          "?#.......#??#",
          "?#########?##",
      },
      0.2);
  AreaParams params;
  params.max_clutter_diagonal = 0.6;
  params.min_island_size = 0.1;
  const cv::Mat1b free_space = cleanFreeSpace(map, params);
  EXPECT_EQ(free_space(3, 4), 1) << "two pixels across";
  EXPECT_EQ(free_space(2, 11), 0) << "an island of 0.04 m^2";
  EXPECT_EQ(free_space(5, 10), 1) << "an island of 0.16 m^2";
  EXPECT_EQ(free_space(1, 1), 0) << "the wall is larger";
  params.max_clutter_diagonal = 0.5;
  EXPECT_EQ(cleanFreeSpace(map, params)(3, 4), 0);
}

TEST(FreeSpace, ClutterAtTheMapsBorderIsWall) {
  const OccupancyMap map = test::asciiMap({"#....", ".....", "..#..", ".....", "....."}, 0.1);
  AreaParams params;
  params.min_island_size = 0;
  const cv::Mat1b free_space = cleanFreeSpace(map, params);
  EXPECT_EQ(free_space(4, 0), 0);
  EXPECT_EQ(free_space(2, 2), 1);
}

TEST(FreeSpace, DistancesAreThoseToTheNearestOfAllWalls) {
  std::mt19937 random(4);
  cv::Mat1b free_space(19, 27);
  for (std::uint8_t& pixel : free_space) pixel = random() % 11 == 0 ? 0 : 1;
  const cv::Mat1f distance = distanceFromWalls(free_space);
  for (int y = 0; y < free_space.rows; ++y) {
    for (int x = 0; x < free_space.cols; ++x) {
      double nearest = 1e9;
      for (int v = -1; v <= free_space.rows; ++v) {
        for (int u = -1; u <= free_space.cols; ++u) {
          const bool in_map = u >= 0 && v >= 0 && u < free_space.cols && v < free_space.rows;
          if (in_map && free_space(v, u) != 0) continue;
          nearest = std::min(nearest, std::hypot(u - x, v - y));
        }
      }
      EXPECT_NEAR(distance(y, x), nearest, 1e-5);
    }
  }
}

TEST(FreeSpace, DistancesStayExactOnWideMaps) {
  cv::Mat1b free_space(60, 10000, std::uint8_t{0});
  free_space.rowRange(10, 50) = 1;
  const cv::Mat1f distance = distanceFromWalls(free_space);
  for (int y = 0; y < free_space.rows; ++y) {
    const int expected = y < 10 || y >= 50 ? 0 : std::min(y - 9, 50 - y);
    for (int x = 40; x < free_space.cols - 40; ++x) ASSERT_EQ(distance(y, x), expected) << x;
  }
}

}  // namespace
}  // namespace agrid
