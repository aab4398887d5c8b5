// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pixel_walk.h"

#include <random>

#include <gtest/gtest.h>

namespace agrid::planning {
namespace {

__extension__ typedef __int128 Wide;

/// Whether a segment and a closed pixel square meet, in exact integers: their boxes overlap, and
/// the square's corners do not all lie strictly on one side of the line.
bool touches(Pixel p, FinePoint a, FinePoint b) {
  const std::int64_t x0 = p.x * kFine - kFine / 2;
  const std::int64_t y0 = p.y * kFine - kFine / 2;
  if (std::max(a.x, b.x) < x0 || std::min(a.x, b.x) > x0 + kFine) return false;
  if (std::max(a.y, b.y) < y0 || std::min(a.y, b.y) > y0 + kFine) return false;
  int above = 0;
  int below = 0;
  for (const std::int64_t x : {x0, x0 + kFine}) {
    for (const std::int64_t y : {y0, y0 + kFine}) {
      const Wide side = Wide{b.x - a.x} * (y - a.y) - Wide{b.y - a.y} * (x - a.x);
      if (side >= 0) ++above;
      if (side <= 0) ++below;
    }
  }
  return above > 0 && below > 0;
}

void expectExact(const SegmentRaster& raster, FinePoint a, FinePoint b, int column) {
  const SegmentRaster::Rows rows = raster.touched(column);
  const auto text = [&] {
    return std::to_string(a.x) + "," + std::to_string(a.y) + " to " + std::to_string(b.x) + "," +
           std::to_string(b.y) + " column " + std::to_string(column);
  };
  ASSERT_LE(rows.low, rows.high) << text();
  EXPECT_TRUE(touches(raster.pixel(column, rows.low), a, b)) << text();
  EXPECT_TRUE(touches(raster.pixel(column, rows.high), a, b)) << text();
  EXPECT_FALSE(touches(raster.pixel(column, rows.low - 1), a, b)) << text();
  EXPECT_FALSE(touches(raster.pixel(column, rows.high + 1), a, b)) << text();
}

/// At the ends, around `middle`, and at some places.
void expectExactAlong(std::mt19937& random, FinePoint a, FinePoint b, FinePoint middle) {
  const SegmentRaster raster(a, b);
  const int low = std::min(raster.first(), raster.last());
  const int high = std::max(raster.first(), raster.last());
  const bool is_steep = raster.pixel(1, 0).y == 1;
  const Pixel center = middle.pixel();
  for (int d = -2; d <= 2; ++d) {
    for (const int column : {low + d, high + d, (is_steep ? center.y : center.x) + d}) {
      if (column >= low && column <= high) expectExact(raster, a, b, column);
    }
  }
  for (int i = 0; i < 10; ++i) {
    expectExact(raster, a, b, std::uniform_int_distribution<int>(low, high)(random));
  }
  EXPECT_FALSE(touches(raster.pixel(low - 1, raster.touched(low).low), a, b));
  EXPECT_FALSE(touches(raster.pixel(high + 1, raster.touched(high).low), a, b));
}

/// In maps of 2^20 by 953 pixels, the most that is allowed.
struct Frame {
  std::int64_t width = std::int64_t{1} << 20;
  std::int64_t height = 953;
  bool holds(FinePoint p) const {
    return p.x >= 0 && p.y >= 0 && p.x < width * kFine && p.y < height * kFine;
  }
};

FinePoint flipped(FinePoint p, bool flip) { return flip ? FinePoint{p.y, p.x} : p; }

TEST(SegmentRaster, TouchesWhatExactArithmeticSays) {
  std::mt19937 random(34);
  const Frame frame;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::int64_t span = std::int64_t{1} << std::uniform_int_distribution<int>(1, 20)(random);
    std::uniform_int_distribution<std::int64_t> x(0, span * kFine - 1);
    std::uniform_int_distribution<std::int64_t> y(0, std::min(span, frame.height) * kFine - 1);
    const FinePoint a = flipped({x(random), y(random)}, trial % 2 == 0);
    const FinePoint b = flipped({x(random), y(random)}, trial % 2 == 0);
    expectExactAlong(random, a, b, a);
    if (HasFailure()) return;
  }
}

/// Exactly through a corner of pixels, and past it by a step or two of the lattice.
TEST(SegmentRaster, GrazesCornersExactly) {
  std::mt19937 random(35);
  const Frame frame;
  int far = 0;
  for (int trial = 0; trial < 60000; ++trial) {
    std::uniform_int_distribution<std::int64_t> column(0, frame.width - 1);
    std::uniform_int_distribution<std::int64_t> row(0, frame.height - 1);
    const FinePoint corner{column(random) * kFine + kFine / 2, row(random) * kFine + kFine / 2};
    std::uniform_int_distribution<std::int64_t> part(-40, 40);
    std::uniform_int_distribution<std::int64_t> scale(1, 1 << (trial % 30));
    const FinePoint step{part(random) * scale(random), part(random)};
    const std::int64_t before = scale(random);
    const std::int64_t after = scale(random);
    FinePoint a{corner.x - before * step.x, corner.y - before * step.y};
    const FinePoint b{corner.x + after * step.x, corner.y + after * step.y};
    a.y += part(random) / 20;
    if (!frame.holds(a) || !frame.holds(b)) continue;
    far += std::abs(a.x - b.x) > 100000 * kFine ? 1 : 0;
    const bool flip = trial % 2 == 0;
    expectExactAlong(random, flipped(a, flip), flipped(b, flip), flipped(corner, flip));
    if (HasFailure()) return;
  }
  EXPECT_GT(far, 100);
}

TEST(SegmentRaster, RunsAlongBordersTouchBothSides) {
  std::mt19937 random(36);
  const Frame frame;
  for (int trial = 0; trial < 4000; ++trial) {
    std::uniform_int_distribution<std::int64_t> x(0, frame.width * kFine - 1);
    std::uniform_int_distribution<std::int64_t> row(0, frame.height - 2);
    std::uniform_int_distribution<std::int64_t> shift(-1, 1);
    const std::int64_t y = row(random) * kFine + kFine / 2;
    const FinePoint a = flipped({x(random), y + shift(random)}, trial % 2 == 0);
    const FinePoint b = flipped({x(random), y + shift(random)}, trial % 2 == 0);
    expectExactAlong(random, a, b, b);
    if (HasFailure()) return;
  }
  const SegmentRaster along({0, kFine / 2}, {50 * kFine, kFine / 2});
  EXPECT_EQ(along.touched(20).low, 0);
  EXPECT_EQ(along.touched(20).high, 1);
}

}  // namespace
}  // namespace agrid::planning
