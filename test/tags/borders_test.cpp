// SPDX-License-Identifier: BSD-3-Clause
#include "tags/borders.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tags/basins.h"

namespace agrid {
namespace {

constexpr std::uint32_t kNone = Basins::kNone;

/// Labels from digits, '#' = none; the first row has the smallest y.
std::vector<std::uint32_t> labelsOf(const std::vector<std::string>& rows) {
  std::vector<std::uint32_t> labels;
  for (const std::string& row : rows) {
    for (const char c : row)
      labels.push_back(c == '#' ? kNone : static_cast<std::uint32_t>(c - '0'));
  }
  return labels;
}

MapGeometry geometryOf(const std::vector<std::string>& rows) {
  return {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1, {}};
}

TEST(Borders, PointsAreAllPairsThatTouchByASide) {
  std::mt19937 random(5);
  for (int run = 0; run < 30; ++run) {
    const MapGeometry geometry{
        1 + static_cast<int>(random() % 12), 1 + static_cast<int>(random() % 9), 1, {}};
    std::vector<std::uint32_t> labels(geometry.pixelCount());
    for (std::uint32_t& label : labels) {
      label = random() % 4 == 0 ? kNone : static_cast<std::uint32_t>(random() % 3);
    }
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::size_t, std::size_t>;
    std::vector<Key> expected;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Pixel p = geometry.pixel(i);
      for (const Pixel q : {Pixel{p.x + 1, p.y}, Pixel{p.x, p.y + 1}}) {
        if (!geometry.contains(q)) continue;
        const std::uint32_t other = labels[geometry.index(q)];
        if (labels[i] == other || labels[i] == kNone || other == kNone) continue;
        expected.emplace_back(std::min(labels[i], other), std::max(labels[i], other), i,
                              geometry.index(q));
      }
    }
    std::sort(expected.begin(), expected.end());
    std::vector<Key> found;
    for (const BorderPoint& point : findBorderPoints(labels, geometry)) {
      found.emplace_back(point.a, point.b, point.pixel, point.other);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(Borders, APointLiesBetweenItsPixels) {
  const MapGeometry geometry{4, 3, 0.05, {}};
  const BorderPoint beside{0, 1, geometry.index({1, 2}), geometry.index({2, 2})};
  EXPECT_EQ(beside.position(geometry), Point2(2, 2.5));
  const BorderPoint above{0, 1, geometry.index({1, 1}), geometry.index({1, 2})};
  EXPECT_EQ(above.position(geometry), Point2(1.5, 2));
}

TEST(Borders, PiecesAreSplitWhereTheyAreMoreThanThreePixelsApart) {
  const std::vector<std::string> near{"0011", "0011", "####", "####", "0011"};
  const std::vector<std::string> far{"0011", "0011", "####", "####", "####", "0011"};
  const auto one =
      splitIntoStretches(findBorderPoints(labelsOf(near), geometryOf(near)), geometryOf(near));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].size(), 3U);
  const auto two =
      splitIntoStretches(findBorderPoints(labelsOf(far), geometryOf(far)), geometryOf(far));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].size(), 2U);
  EXPECT_EQ(two[1].size(), 1U);
}

TEST(Borders, EachPairHasItsOwnStretches) {
  const std::vector<std::string> rows{"001122", "001122", "333333"};
  const auto stretches =
      splitIntoStretches(findBorderPoints(labelsOf(rows), geometryOf(rows)), geometryOf(rows));
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::size_t>> found;
  for (const Stretch& stretch : stretches) {
    found.emplace_back(stretch[0].a, stretch[0].b, stretch.size());
  }
  const decltype(found) expected{{0, 1, 2}, {0, 3, 2}, {1, 2, 2}, {1, 3, 2}, {2, 3, 2}};
  EXPECT_EQ(found, expected);
}

TEST(Borders, TheExtentIsTheDiagonalOfAllPoints) {
  const std::vector<std::string> straight{"01", "01", "01", "01", "01"};
  const auto geometry = geometryOf(straight);
  const auto column = splitIntoStretches(findBorderPoints(labelsOf(straight), geometry), geometry);
  EXPECT_DOUBLE_EQ(extentOf(column.at(0), geometry), 5);
  const std::vector<std::string> stairs{"0111", "0011", "0001"};
  const auto slanted = splitIntoStretches(findBorderPoints(labelsOf(stairs), geometryOf(stairs)),
                                          geometryOf(stairs));
  ASSERT_EQ(slanted.size(), 1U);
  EXPECT_DOUBLE_EQ(extentOf(slanted[0], geometryOf(stairs)), std::hypot(2, 2) + 1);
}

}  // namespace
}  // namespace agrid
