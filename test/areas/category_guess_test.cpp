// SPDX-License-Identifier: BSD-3-Clause
#include "areas/category_guess.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/segmentation.h"

namespace agrid {
namespace {

using Drawing = std::vector<std::string>;

constexpr double kSide = 0.5;  // of a drawn square [m]

/// A drawing of squares of 0.5 m as a map of any resolution, turned about its middle; what lies
/// beyond the drawing is unknown. The point (0, 0) of the map frame is the drawing's middle.
OccupancyMap drawn(const Drawing& rows, double resolution, double yaw) {
  const double height = static_cast<double>(rows.size()) * kSide;
  const double width = static_cast<double>(rows.at(0).size()) * kSide;
  const int side = static_cast<int>(std::ceil(std::hypot(width, height) / resolution)) + 2;
  Drawing pixels(static_cast<std::size_t>(side), std::string(static_cast<std::size_t>(side), '?'));
  const Pose2 drawing_from_map{{0, 0}, -yaw};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Point2 from_middle = Point2(x + 0.5 - side / 2.0, side / 2.0 - y - 0.5) * resolution;
      const Point2 at = drawing_from_map * from_middle;
      const double column = std::floor((at.x() + width / 2) / kSide);
      const double row = std::floor((height / 2 - at.y()) / kSide);
      if (column < 0 || row < 0 || column * kSide >= width || row * kSide >= height) continue;
      pixels[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
          rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
  }
  const double corner = -side * resolution / 2;
  return test::asciiMap(pixels, resolution, {{corner, corner}, 0});
}

/// What the area at a square of the drawing is taken for, however the map is turned and resolved;
/// what differs is listed.
std::string guessAt(const Drawing& rows, int row, int column) {
  std::string result;
  for (const double resolution : {0.05, 0.025, 0.1}) {
    for (const double degrees : {0.0, 30.0, 45.0, 97.0}) {
      const double yaw = degrees * M_PI / 180;
      const OccupancyMap map = drawn(rows, resolution, yaw);
      const AreaMap areas = test::segment(map);
      const Point2 at(column + 0.5 - static_cast<double>(rows.at(0).size()) / 2,
                      static_cast<double>(rows.size()) / 2 - row - 0.5);
      const Point2 point = Pose2{{0, 0}, yaw} * Point2(at * kSide);
      const auto label =
          areas.pixel_labels.at(map.geometry().index(*map.geometry().pixelAt(point)));
      const std::string guess = label == 0 ? "none" : areas.areas.at(label - 1U).category_guess;
      if (result.empty()) result = guess;
      if (guess != result) {
        return result + ", but " + guess + " at " + std::to_string(resolution) + " m, turned by " +
               std::to_string(degrees);
      }
    }
  }
  return result;
}

// corridor of 2 x 15 m, two rooms, a closet of 2 x 2 m
const Drawing kFloor = {
    "################################", "#..........#....#..............#",
    "#..........#....#..............#", "#..........#....#..............#",
    "#..........#....#..............#", "#..........###..#..............#",
    "#..........#.#..#..............#", "#..........#.#..#..............#",
    "#####..######.####......########", "#####..#####...####..###########",
    "#..............................#", "#..............................#",
    "#..............................#", "#..............................#",
    "################################",
};

TEST(CategoryGuess, CorridorAndRooms) {
  EXPECT_EQ(guessAt(kFloor, 12, 3), "corridor");
  EXPECT_EQ(guessAt(kFloor, 3, 5), "room");
}

TEST(CategoryGuess, ClosetBesideARoom) {
  const Drawing rows = {
      "####################",  //
      "#.............#....#",  //
      "#.............#....#",  //
      "#.............#....#",  //
      "#.............#....#",  //
      "#.............##..##",  //
      "#.............##..##",  //
      "#..................#",  //
      "#..................#",  //
      "#..................#",  //
      "#..................#",  //
      "####################",
  };
  EXPECT_EQ(guessAt(rows, 2, 16), "closet");
  EXPECT_EQ(guessAt(rows, 5, 5), "room");
}

TEST(CategoryGuess, CorridorRoundACorner) {
  Drawing rows(24, std::string(24, '#'));
  for (std::size_t i = 1; i < 23; ++i) {
    for (std::size_t across = 1; across < 5; ++across) rows[i][across] = rows[across][i] = '.';
  }
  EXPECT_EQ(guessAt(rows, 20, 2), "corridor");
}

TEST(CategoryGuess, CorridorThatIsARing) {
  Drawing rows(30, std::string(30, '#'));
  for (std::size_t i = 1; i < 29; ++i) {
    for (std::size_t across = 1; across < 5; ++across) {
      rows[i][across] = rows[across][i] = rows[i][29 - across] = rows[29 - across][i] = '.';
    }
  }
  EXPECT_EQ(guessAt(rows, 2, 15), "corridor");
}

TEST(CategoryGuess, HallIsLargeAndNotLong) {
  Drawing rows(24, "#" + std::string(24, '.') + "#");
  rows.front() = rows.back() = std::string(26, '#');
  EXPECT_EQ(guessAt(rows, 12, 12), "hall");
  rows.resize(18);
  rows.back() = rows.front();
  EXPECT_EQ(guessAt(rows, 12, 12), "room");
}

// cabinets along the walls leave a shape with a long border
TEST(CategoryGuess, FurnishedRoomIsNoCorridor) {
  const Drawing rows = {
      "############",  //
      "#..##..##..#",  //
      "#..##..##..#",  //
      "###......###",  //
      "#..........#",  //
      "#..........#",  //
      "###......###",  //
      "#..##..##..#",  //
      "#..##..##..#",  //
      "############",
  };
  EXPECT_EQ(guessAt(rows, 4, 5), "room");
}

TEST(CategoryGuess, DoesNotTouchAGivenCategory) {
  AreaTag tag;
  tag.category = "kitchen";
  tag.seed_map = {-5, 2};
  int given = 0;
  for (const Area& area : test::segment(drawn(kFloor, 0.05, 0), {tag}).areas) {
    EXPECT_NE(area.category_guess, "");
    if (area.category.empty()) continue;
    ++given;
    EXPECT_EQ(area.category, "kitchen");
    EXPECT_EQ(area.category_guess, "room");
  }
  EXPECT_EQ(given, 1);
}

/// A rectangle's, walls on all sides.
AreaShape rectangle(double width, double length, std::size_t doors) {
  return {width * length, width / 4 - width * width / (12 * length), width / 2, doors};
}

TEST(CategoryGuess, BoundsOfWidthAndLength) {
  EXPECT_EQ(guessCategory(rectangle(2, 8.2, 1)), "corridor");
  EXPECT_EQ(guessCategory(rectangle(2, 7.8, 1)), "room");
  EXPECT_EQ(guessCategory(rectangle(3.9, 20, 1)), "corridor");
  EXPECT_EQ(guessCategory(rectangle(4.1, 20, 1)), "room");
  EXPECT_EQ(guessCategory(rectangle(4.1, 30, 1)), "hall");
  EXPECT_EQ(guessCategory(rectangle(0.7, 8, 1)), "closet");
  EXPECT_EQ(guessCategory(rectangle(2.5, 2.5, 1)), "closet");
  EXPECT_EQ(guessCategory(rectangle(2.6, 2.6, 1)), "room");
  EXPECT_EQ(guessCategory(rectangle(9.9, 9.9, 1)), "room");
  EXPECT_EQ(guessCategory(rectangle(10.1, 10.1, 1)), "hall");
}

TEST(CategoryGuess, DoorsTellAHallwayFromARoom) {
  EXPECT_EQ(guessCategory(rectangle(2.4, 5, 2)), "room");
  EXPECT_EQ(guessCategory(rectangle(2.4, 5, 3)), "corridor");
  EXPECT_EQ(guessCategory(rectangle(2.6, 6, 3)), "room");
  EXPECT_EQ(guessCategory(rectangle(1.2, 2.5, 4)), "corridor");
  AreaShape bulging = rectangle(2, 20, 2);
  bulging.max_clearance = 1.7;
  EXPECT_EQ(guessCategory(bulging), "room");
  bulging.doors = 3;
  EXPECT_EQ(guessCategory(bulging), "corridor");
}

}  // namespace
}  // namespace agrid
