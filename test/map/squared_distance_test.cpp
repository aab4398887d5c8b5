// SPDX-License-Identifier: BSD-3-Clause
#include "map/squared_distance.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace agrid {
namespace {

TEST(SquaredDistances, AreThoseOfASearchOverAllMarkedPixels) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::uniform_int_distribution<int> side(1, 30);
    const MapGeometry geometry{side(random), side(random), 1, {}};
    std::bernoulli_distribution marks(trial % 3 == 0 ? 0.01 : 0.1);
    std::vector<std::uint8_t> marked(geometry.pixelCount());
    for (auto& m : marked) m = marks(random) ? 1 : 0;
    const auto distances = squaredDistances(geometry, marked);
    for (std::size_t i = 0; i < marked.size(); ++i) {
      std::int32_t nearest = kFarSquared;
      for (std::size_t k = 0; k < marked.size(); ++k) {
        if (marked[k] == 0) continue;
        const int dx = geometry.pixel(i).x - geometry.pixel(k).x;
        const int dy = geometry.pixel(i).y - geometry.pixel(k).y;
        nearest = std::min(nearest, dx * dx + dy * dy);
      }
      ASSERT_EQ(distances[i], nearest) << "trial " << trial << " pixel " << i;
    }
  }
}

TEST(SquaredDistances, AreExactNearAndFarAndWhereBothMeet) {
  std::mt19937 random(3);
  for (std::size_t marks = 1; marks < 30; marks += 4) {
    const MapGeometry geometry{701, 300, 1, {}};
    std::vector<std::uint8_t> marked(geometry.pixelCount());
    std::vector<Pixel> places;
    for (std::size_t i = 0; i < marks; ++i) {
      places.push_back(geometry.pixel(random() % marked.size()));
      marked[geometry.index(places.back())] = 1;
    }
    const auto distances = squaredDistances(geometry, marked);
    for (std::size_t i = 0; i < marked.size(); ++i) {
      const Pixel p = geometry.pixel(i);
      std::int32_t nearest = kFarSquared;
      for (const Pixel q : places) {
        nearest = std::min(nearest, (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
      }
      ASSERT_EQ(distances[i], nearest) << marks << " marks, pixel " << i;
    }
  }
}

TEST(SquaredDistances, CountThePixelsAroundTheMapIfTheyAreMarked) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    std::uniform_int_distribution<int> side(1, 40);
    const MapGeometry inner{side(random), side(random), 1, {}};
    const MapGeometry framed{inner.width + 2, inner.height + 2, 1, {}};
    std::vector<std::uint8_t> marked(inner.pixelCount());
    std::vector<std::uint8_t> marked_with_frame(framed.pixelCount(), 1);
    for (std::size_t i = 0; i < marked.size(); ++i) {
      const Pixel p = inner.pixel(i);
      marked[i] = random() % 90 == 0 ? 1 : 0;
      marked_with_frame[framed.index({p.x + 1, p.y + 1})] = marked[i];
    }
    const auto expected = squaredDistances(framed, marked_with_frame);
    int next = inner.height - 1;
    forEachRowOfSquaredDistances(
        inner, marked.data(), Surroundings::kMarked, [&](int y, const std::int32_t* squared) {
          ASSERT_EQ(y, next--);
          for (int x = 0; x < inner.width; ++x) {
            ASSERT_EQ(squared[x], expected[framed.index({x + 1, y + 1})]) << x << " " << y;
          }
        });
    EXPECT_EQ(next, -1);
  }
}

TEST(SquaredDistances, StayExactWhereFloatsDoNot) {
  const MapGeometry geometry{20000, 1, 1, {}};
  std::vector<std::uint8_t> marked(geometry.pixelCount());
  marked[0] = 1;
  EXPECT_EQ(squaredDistances(geometry, marked)[19999], 19999 * 19999);
}

TEST(SquaredDistances, EndAtTheLargestNumberTheyHold) {
  const MapGeometry geometry{50000, 1, 1, {}};
  std::vector<std::uint8_t> marked(geometry.pixelCount());
  marked[0] = 1;
  EXPECT_EQ(squaredDistances(geometry, marked)[49999], kFarSquared);
}

TEST(SquaredDistances, EndWhenTheCallerThrows) {
  const auto stop = [] { throw std::runtime_error("enough"); };
  EXPECT_THROW(squaredDistances({3, 3, 1, {}}, std::vector<std::uint8_t>(9), stop),
               std::runtime_error);
}

}  // namespace
}  // namespace agrid
