// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/perturbation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/generated_maps.h"

namespace agrid {
namespace {

using Labels = std::vector<std::uint16_t>;

OccupancyMap someMap() {
  return test::asciiMap(
      {
          "#####",
          "#..?#",
          "#...#",
      },
      0.5, {{3, -2}, 0.3});
}

bool samePixels(const OccupancyMap& a, const OccupancyMap& b) {
  return a.geometry().width == b.geometry().width && a.geometry().height == b.geometry().height &&
         a.pixels() == b.pixels();
}

std::size_t countOf(const OccupancyMap& map, Occupancy occupancy) {
  return static_cast<std::size_t>(std::count(map.pixels().begin(), map.pixels().end(), occupancy));
}

TEST(Perturbation, AQuarterTurnMovesEveryPixel) {
  const OccupancyMap expected = test::asciiMap({
      "###",
      "#?.",
      "#..",
      "#..",
      "###",
  });
  EXPECT_TRUE(samePixels(turned(someMap(), 90), expected));
  EXPECT_TRUE(samePixels(turned(turned(someMap(), 90), -90), someMap()));
  EXPECT_TRUE(samePixels(turned(someMap(), 360), someMap()));
}

TEST(Perturbation, WhatIsSeenStaysWhereItWas) {
  const OccupancyMap map(test::noise(7, 40, 23, 0.3));
  for (const double degrees : {7.0, 45.0, 120.0, -170.0}) {
    const OccupancyMap other = turned(map, degrees);
    for (int y = 0; y < other.geometry().height; ++y) {
      for (int x = 0; x < other.geometry().width; ++x) {
        const auto p = map.geometry().pixelAt(other.geometry().center({x, y}));
        EXPECT_EQ(other.at({x, y}), p ? map.at(*p) : Occupancy::kUnknown);
      }
    }
  }
}

TEST(Perturbation, TheCanvasHoldsEveryPixel) {
  for (const double degrees : {7.0, 30.0, 45.0, 100.0, -170.0}) {
    const OccupancyMap map(test::uniform(31, 12, 0));
    const OccupancyMap other = turned(map, degrees);
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 31; ++x) {
        EXPECT_TRUE(other.geometry().pixelAt(map.geometry().center({x, y}))) << degrees;
      }
    }
    EXPECT_NEAR(static_cast<double>(countOf(other, Occupancy::kFree)), 31 * 12, 12) << degrees;
  }
}

TEST(Perturbation, FinerPixelsRepeatAndComeBack) {
  const OccupancyMap fine = resampled(someMap(), 0.25);
  EXPECT_EQ(fine.geometry().width, 10);
  EXPECT_EQ(fine.geometry().height, 6);
  EXPECT_EQ(countOf(fine, Occupancy::kFree), 4 * countOf(someMap(), Occupancy::kFree));
  EXPECT_TRUE(samePixels(resampled(fine, 0.5), someMap()));
}

TEST(Perturbation, CoarserPixelsCoverTheWholeMap) {
  const OccupancyMap coarse = resampled(someMap(), 1);
  EXPECT_EQ(coarse.geometry().width, 3);
  EXPECT_EQ(coarse.geometry().height, 2);
  EXPECT_DOUBLE_EQ(coarse.geometry().resolution, 1);
}

TEST(Perturbation, ResolutionsOutOfBoundsAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double resolution : {0.0, -0.05, nan, 1e-9, 11.0}) {
    EXPECT_THROW(resampled(someMap(), resolution), MapError) << resolution;
  }
}

TEST(Perturbation, NoiseWearsObstaclesAndStrewsPoints) {
  const OccupancyMap map(test::noise(3, 400, 400, 0.01));
  const OccupancyMap other = noisy(map, 1);
  const auto touches = [&](Pixel p) {
    for (int i = 0; i < 9; ++i) {
      const Pixel q{p.x + i % 3 - 1, p.y + i / 3 - 1};
      if (map.geometry().contains(q) && !map.isFree(q)) return true;
    }
    return false;
  };
  double at_obstacles = 0;
  double worn = 0;
  double others = 0;
  double strewn = 0;
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    const bool hit = other.pixels()[i] == Occupancy::kOccupied;
    if (map.pixels()[i] != Occupancy::kFree) {
      EXPECT_EQ(other.pixels()[i], map.pixels()[i]);
      continue;
    }
    const bool near = touches(map.geometry().pixel(i));
    (near ? at_obstacles : others) += 1;
    if (hit) (near ? worn : strewn) += 1;
  }
  EXPECT_NEAR(worn / at_obstacles, 0.30, 0.02);
  EXPECT_NEAR(strewn / others, 0.001, 0.0005);
}

TEST(Perturbation, NoiseIsTheSeedsAlone) {
  const OccupancyMap map(test::noise(3, 100, 100, 0.05));
  EXPECT_EQ(noisy(map, 1).pixels(), noisy(map, 1).pixels());
  EXPECT_NE(noisy(map, 1).pixels(), noisy(map, 2).pixels());
}

TEST(Perturbation, UnknownPixelsStayUnknown) {
  const OccupancyMap map = someMap();
  EXPECT_EQ(countOf(noisy(map, 5), Occupancy::kUnknown), 1U);
}

TEST(Perturbation, LabelsComeBackToTheirPixels) {
  const OccupancyMap map(test::uniform(60, 45, 0));
  Labels labels(map.pixels().size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Pixel p = map.geometry().pixel(i);
    labels[i] = static_cast<std::uint16_t>(1 + p.x / 20 + 3 * (p.y / 15));
  }
  for (const OccupancyMap& other : {turned(map, 30), resampled(map, 0.02), resampled(map, 0.1)}) {
    const Labels there = labelsOn(other.geometry(), map.geometry(), labels);
    const Labels back = labelsOn(map.geometry(), other.geometry(), there);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Pixel p = map.geometry().pixel(i);
      const bool inside = p.x % 20 > 1 && p.x % 20 < 18 && p.y % 15 > 1 && p.y % 15 < 13;
      if (inside) {
        ASSERT_EQ(back[i], labels[i]) << p.x << " " << p.y;
      }
    }
  }
  EXPECT_THROW(labelsOn(map.geometry(), map.geometry(), Labels(3)), std::invalid_argument);
}

}  // namespace
}  // namespace agrid
