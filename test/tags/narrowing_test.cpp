// SPDX-License-Identifier: BSD-3-Clause
#include "tags/narrowing.h"

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "tags/free_space.h"

namespace agrid {
namespace {

Segment narrowingAt(const std::vector<std::string>& rows, Pixel pixel) {
  const OccupancyMap map = test::asciiMap(rows);
  cv::Mat1b free_space(map.geometry().height, map.geometry().width);
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    free_space.ptr()[i] = map.pixels()[i] == Occupancy::kFree ? 1 : 0;
  }
  return findNarrowing(pixel, distanceFromWalls(free_space));
}

TEST(Narrowing, IsTheOpeningOfADoorway) {
  const Segment jambs = narrowingAt(
      {
          "....#....",
          "....#....",
          ".........",
          ".........",
          ".........",
          "....#....",
          "....#....",
      },
      {4, 3});
  EXPECT_DOUBLE_EQ(jambs.length(), 3);
  EXPECT_DOUBLE_EQ(jambs.a.x(), 4.5);
  EXPECT_DOUBLE_EQ(jambs.b.x(), 4.5);
  EXPECT_DOUBLE_EQ(jambs.midpoint().y(), 3.5);
}

TEST(Narrowing, MovesAlongTheWallsToWhereTheyAreClosest) {
  const Segment jambs = narrowingAt(
      {
          "#########",
          "....##...",
          ".........",
          ".........",
          ".........",
          "##.......",
          "#########",
      },
      {3, 3});
  // from the centre of (1, 1) to that of (4, 5) it is 5; the straight way up would leave 4
  EXPECT_DOUBLE_EQ(jambs.length(), 5 - 5. / 4);
}

TEST(Narrowing, OfASlitIsAsWideAsAPixel) {
  EXPECT_DOUBLE_EQ(narrowingAt({"..#..", ".....", "..#.."}, {2, 1}).length(), 1);
}

TEST(Narrowing, TakesWhatLiesBeyondTheMapForWall) {
  EXPECT_DOUBLE_EQ(narrowingAt({".....", ".....", "....."}, {2, 1}).length(), 3);
}

}  // namespace
}  // namespace agrid
