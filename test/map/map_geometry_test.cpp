// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/map/map_geometry.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

TEST(MapGeometry, PixelCentersReturnToTheirPixelsAtAnyOrigin) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-20, 20);
  for (int trial = 0; trial < 20; ++trial) {
    const MapGeometry geometry{17, 9, 0.025, {{value(random), value(random)}, value(random)}};
    for (std::size_t i = 0; i < geometry.pixelCount(); ++i) {
      const auto pixel = geometry.pixelAt(geometry.center(geometry.pixel(i)));
      ASSERT_TRUE(pixel);
      EXPECT_EQ(geometry.index(*pixel), i);
    }
  }
}

TEST(MapGeometry, RowZeroHasTheSmallestY) {
  const MapGeometry geometry{4, 3, 0.5, {{10, 20}, 0}};
  EXPECT_TRUE(geometry.pixelAt({10.1, 20.1}) == Pixel({0, 0}));
  EXPECT_TRUE(geometry.pixelAt({11.9, 21.4}) == Pixel({3, 2}));
}

TEST(MapGeometry, PointsOutsideAndNanHaveNoPixel) {
  const MapGeometry geometry{4, 3, 0.5, {}};
  EXPECT_FALSE(geometry.pixelAt({-1e-9, 0}));
  EXPECT_FALSE(geometry.pixelAt({2, 0}));
  EXPECT_FALSE(geometry.pixelAt({std::nan(""), 0}));
  EXPECT_FALSE(geometry.pixelAt({1e300, 1}));
}

TEST(MapGeometry, CountsPixelsIn64Bits) {
  const MapGeometry geometry{100000, 100000, 0.05, {}};
  EXPECT_EQ(geometry.pixelCount(), 10000000000U);
  EXPECT_EQ(geometry.index({99999, 99999}), 9999999999U);
}

}  // namespace
}  // namespace agrid
