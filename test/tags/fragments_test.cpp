// SPDX-License-Identifier: BSD-3-Clause
#include "tags/fragments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "support/drawn_plan.h"
#include "tags/borders.h"
#include "tags/free_space.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

using test::DrawnPlan;

constexpr std::uint32_t kNone = Basins::kNone;
constexpr double kResolution = 0.05;

Relief reliefOf(const cv::Mat1b& space) {
  Relief relief;
  relief.free_space = space;
  relief.height = distanceFromWalls(space);
  return relief;
}

MapGeometry geometryOf(const Relief& relief) {
  return {relief.free_space.cols, relief.free_space.rows, kResolution, {}};
}

/// Offices as they are drawn for tests, and heaps of rectangles.
std::vector<Relief> manyReliefs() {
  std::vector<Relief> reliefs;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    OfficeParams params;
    params.size = 300;
    params.seed = seed;
    reliefs.push_back(reliefOf(cleanFreeSpace(OccupancyMap(generateOffice(params).grid), {})));
  }
  std::mt19937 random(2);
  const auto pick = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
  };
  for (int run = 0; run < 25; ++run) {
    cv::Mat1b space(80, 110, std::uint8_t{0});
    for (int k = 0; k < 10; ++k) {
      space(cv::Rect(pick(0, 70), pick(0, 50), pick(3, 40), pick(3, 30))) = 1;
    }
    reliefs.push_back(reliefOf(space));
  }
  return reliefs;
}

/// Pixels of a value that hang together by sides and corners with the first, which they include.
std::vector<std::size_t> component(const std::vector<std::uint32_t>& values, std::size_t first,
                                   const MapGeometry& geometry) {
  std::vector<std::size_t> found{first};
  std::set<std::size_t> seen{first};
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const Pixel step : kNeighbours) {
      const Pixel q = geometry.pixel(found[k]) + step;
      if (!geometry.contains(q) || values[geometry.index(q)] != values[first]) continue;
      if (seen.insert(geometry.index(q)).second) found.push_back(geometry.index(q));
    }
  }
  return found;
}

TEST(Fragments, EveryFreePixelThatTouchesOneHasOne) {
  for (const Relief& relief : manyReliefs()) {
    const MapGeometry geometry = geometryOf(relief);
    const Fragments fragments = cutIntoFragments(relief, kResolution);
    const auto& labels = fragments.basins.of_pixel;
    ASSERT_EQ(labels.size(), geometry.pixelCount());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const bool is_free = relief.free_space.ptr()[i] != 0;
      if (!is_free) {
        EXPECT_EQ(labels[i], kNone);
      } else if (labels[i] == kNone) {
        EXPECT_EQ(fragments.openings.at_pixel.count(i), 1U) << "only openings may be cut off";
        for (const Pixel step : kNeighbours) {
          const Pixel q = geometry.pixel(i) + step;
          EXPECT_TRUE(!geometry.contains(q) || labels[geometry.index(q)] == kNone);
        }
      }
    }
  }
}

TEST(Fragments, EachHangsTogetherAndIsDescribed) {
  for (const Relief& relief : manyReliefs()) {
    const MapGeometry geometry = geometryOf(relief);
    const Basins basins = cutIntoFragments(relief, kResolution).basins;
    std::vector<bool> seen(basins.basins.size(), false);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < basins.of_pixel.size(); ++i) {
      const std::uint32_t label = basins.of_pixel[i];
      if (label == kNone || (label < seen.size() && seen[label])) continue;
      ASSERT_EQ(label, next++) << "numbered by their first pixels";
      seen[label] = true;
      const Basin& basin = basins.basins.at(label);
      const auto pixels = component(basins.of_pixel, i, geometry);
      EXPECT_EQ(pixels.size(), basin.size_px) << "all of it hangs together";
      float highest = 0;
      for (const std::size_t pixel : pixels) {
        highest = std::max(highest, relief.height.ptr<float>()[pixel]);
      }
      EXPECT_EQ(basin.height, highest);
      EXPECT_EQ(relief.height.ptr<float>()[basin.peak], highest);
      EXPECT_EQ(basins.of_pixel[basin.peak], label);
    }
    EXPECT_EQ(next, basins.basins.size());
  }
}

TEST(Fragments, SmallOnesJoinANeighbourIfTheyHaveOne) {
  for (const Relief& relief : manyReliefs()) {
    const MapGeometry geometry = geometryOf(relief);
    const Basins basins = cutIntoFragments(relief, kResolution).basins;
    for (const BorderPoint& point : findBorderPoints(basins.of_pixel, geometry)) {
      EXPECT_GE(static_cast<double>(basins.basins[point.a].size_px), 0.3 / 0.0025);
      EXPECT_GE(static_cast<double>(basins.basins[point.b].size_px), 0.3 / 0.0025);
    }
  }
}

TEST(Fragments, SaddlesAreTheHighestWaysOverTheirBorders) {
  for (const Relief& relief : manyReliefs()) {
    const MapGeometry geometry = geometryOf(relief);
    const Basins basins = cutIntoFragments(relief, kResolution).basins;
    const auto* height = relief.height.ptr<float>();
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> expected;
    for (const BorderPoint& point : findBorderPoints(basins.of_pixel, geometry)) {
      float& highest = expected[{point.a, point.b}];
      highest = std::max(highest, std::min(height[point.pixel], height[point.other]));
    }
    ASSERT_EQ(basins.saddles.size(), expected.size());
    for (std::size_t i = 0; i < basins.saddles.size(); ++i) {
      const Saddle& saddle = basins.saddles[i];
      EXPECT_LT(saddle.a, saddle.b);
      EXPECT_EQ((expected[{saddle.a, saddle.b}]), saddle.height);
      EXPECT_EQ(height[saddle.pixel], saddle.height);
      const std::uint32_t own = basins.of_pixel[saddle.pixel];
      EXPECT_TRUE(own == saddle.a || own == saddle.b);
      if (i == 0) continue;
      const Saddle& before = basins.saddles[i - 1];
      EXPECT_GT(std::make_tuple(before.height, saddle.a, saddle.b),
                std::make_tuple(saddle.height, before.a, before.b));
    }
  }
}

TEST(Fragments, ADoorIsCutAtItsJambs) {
  const DrawnPlan plan = DrawnPlan(10, 6)
                             .open({0.5, 0.5}, {4.9, 5.5})
                             .open({5.1, 0.5}, {9.5, 5.5})
                             .open({4.5, 2.5}, {5.5, 3.4});
  const Relief relief = reliefOf(plan.freeSpace());
  const Fragments fragments = cutIntoFragments(relief, kResolution);
  ASSERT_EQ(fragments.openings.all.size(), 1U);
  const MapGeometry geometry = geometryOf(relief);
  std::set<int> rows;
  for (const auto& [pixel, opening] : fragments.openings.at_pixel) {
    EXPECT_EQ(opening, 0U);
    EXPECT_NE(relief.free_space.ptr()[pixel], 0);
    EXPECT_NEAR(geometry.pixel(pixel).x, 100, 2.5);
    rows.insert(geometry.pixel(pixel).y);
  }
  EXPECT_EQ(rows.size(), 18U) << "from jamb to jamb";
  EXPECT_NE(fragments.basins.of_pixel[geometry.index({95, 58})],
            fragments.basins.of_pixel[geometry.index({105, 58})]);
}

TEST(Fragments, ANarrowingWithoutCornersIsCutToo) {
  // two round rooms of 4 m whose necks narrow to 1.2 m
  cv::Mat1b space(120, 200, std::uint8_t{0});
  for (int y = 0; y < space.rows; ++y) {
    for (int x = 0; x < space.cols; ++x) {
      const double half = 12 + 28 * std::pow((x + 0.5 - 100) / 60, 2);
      if (std::abs(x + 0.5 - 100) < 60 && std::abs(y + 0.5 - 60) < half) space(y, x) = 1;
    }
  }
  const Basins basins = cutIntoFragments(reliefOf(space), kResolution).basins;
  const MapGeometry geometry{space.cols, space.rows, kResolution, {}};
  EXPECT_NE(basins.of_pixel[geometry.index({80, 60})], basins.of_pixel[geometry.index({120, 60})]);
}

TEST(Fragments, NothingComesOfNothing) {
  const Fragments fragments = cutIntoFragments(reliefOf(cv::Mat1b(9, 7, std::uint8_t{0})), 0.05);
  EXPECT_TRUE(fragments.basins.basins.empty());
  EXPECT_TRUE(fragments.basins.saddles.empty());
  EXPECT_EQ(fragments.basins.of_pixel, std::vector<std::uint32_t>(63, kNone));
}

}  // namespace
}  // namespace agrid
