// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_classes.h"

#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace agrid::planning {
namespace {

constexpr int kBlock = RegionClasses::kBlock;
constexpr int kMaxPoints = RegionClasses::kMaxPoints;
static_assert(kMaxPoints == 200, "the second test below counts parts for it");

/// What is known of a class after looking at every pixel.
struct Class {
  std::set<std::uint16_t> labels;
  std::set<std::pair<int, int>> blocks;
  int points = 0;
};

std::map<std::uint32_t, Class> classesOf(const MapGeometry& g,
                                         const std::vector<std::uint16_t>& labels,
                                         const std::vector<TurningPoint>& points) {
  const RegionClasses classes(g, labels, points);
  std::map<std::uint32_t, Class> found;
  std::vector<std::uint32_t> row(static_cast<std::size_t>(g.width));
  std::vector<std::uint32_t> all;
  for (int y = 0; y < g.height; ++y) {
    classes.classesOfRow(y, row);
    all.insert(all.end(), row.begin(), row.end());
    for (int x = 0; x < g.width; ++x) {
      Class& c = found[row[static_cast<std::size_t>(x)]];
      c.labels.insert(labels[g.index({x, y})]);
      c.blocks.insert({x / kBlock, y / kBlock});
    }
  }
  for (const TurningPoint& point : points) ++found[all[g.index(point.at.pixel())]].points;
  return found;
}

TEST(RegionClasses, DivideAreasOnlyWhereTheyHaveManyTurningPoints) {
  std::mt19937 random(33);
  int divided = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::uniform_int_distribution<int> side(3, 500);
    const MapGeometry g{side(random), side(random), 0.05, {}};
    std::vector<std::uint16_t> labels(g.pixelCount());
    const int strip = side(random);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Pixel p = g.pixel(i);
      labels[i] = static_cast<std::uint16_t>(5 * ((p.x + p.y / 2) / strip % 3));
    }
    std::vector<TurningPoint> points(random() % 1500);
    std::map<std::uint16_t, int> points_of_label;
    for (TurningPoint& point : points) {
      const Pixel p{static_cast<int>(random() % static_cast<unsigned>(g.width)),
                    static_cast<int>(random() % static_cast<unsigned>(g.height))};
      point.at = centerOf(p);
      ++points_of_label[labels[g.index(p)]];
    }
    std::map<std::uint16_t, int> parts;
    for (const auto& [number, c] : classesOf(g, labels, points)) {
      ASSERT_EQ(c.labels.size(), 1U) << "trial " << trial;
      EXPECT_TRUE(c.points <= kMaxPoints || c.blocks.size() == 1) << "trial " << trial;
      ++parts[*c.labels.begin()];
    }
    for (const auto& [label, count] : parts) {
      EXPECT_TRUE(count == 1 || points_of_label[label] > kMaxPoints) << "trial " << trial;
      divided += count > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(divided, 20);
}

TEST(RegionClasses, PartsAreHalvesByTheirPoints) {
  const MapGeometry g{10 * kBlock, kBlock, 0.05, {}};
  std::vector<TurningPoint> points(1000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].at = centerOf({static_cast<int>(i % 10) * kBlock + 10, 10});
  }
  // 1000 = 500 + 500, 500 = 300 + 200, 300 = 200 + 100.
  const auto classes = classesOf(g, std::vector<std::uint16_t>(g.pixelCount()), points);
  EXPECT_EQ(classes.size(), 6U);
}

}  // namespace
}  // namespace agrid::planning
