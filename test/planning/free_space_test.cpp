// SPDX-License-Identifier: BSD-3-Clause
#include "planning/free_space.h"

#include <random>

#include <gtest/gtest.h>

#include "map/squared_distance.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

FreeSpace freeSpace(const MapGeometry& geometry, const std::vector<std::uint8_t>& obstacles,
                    double radius) {
  return {geometry,
          std::make_shared<const planning::SquaredDistances>(squaredDistances(geometry, obstacles)),
          radius};
}

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
      const std::int64_t side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      if (side >= 0) ++above;
      if (side <= 0) ++below;
    }
  }
  return above > 0 && below > 0;
}

FinePoint randomPoint(std::mt19937& random, const MapGeometry& g, int kind) {
  std::uniform_int_distribution<int> x(0, g.width - 1);
  std::uniform_int_distribution<int> y(0, g.height - 1);
  FinePoint p = centerOf({x(random), y(random)});
  std::uniform_int_distribution<std::int64_t> offset(-kFine / 2, kFine / 2);
  if (kind == 1) p = {p.x + offset(random), p.y + offset(random)};
  if (kind == 2) p = {p.x + kFine / 2, p.y};  // on a border
  return p;
}

TEST(FreeSpace, SeesExactlyWhereNoTouchedPixelIsBlocked) {
  std::mt19937 random(2);
  int seen = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::uniform_int_distribution<int> side(3, 40);
    const MapGeometry geometry{side(random), side(random), 1, {}};
    std::bernoulli_distribution marks(trial % 2 == 0 ? 0.003 : 0.03);
    std::vector<std::uint8_t> obstacles(geometry.pixelCount());
    for (auto& m : obstacles) m = marks(random) ? 1 : 0;
    const FreeSpace free = freeSpace(geometry, obstacles, trial % 4);
    for (int i = 0; i < 50; ++i) {
      const FinePoint a = randomPoint(random, geometry, trial % 3);
      const FinePoint b = randomPoint(random, geometry, i % 3);
      bool sees = true;
      for (int y = -1; y <= geometry.height; ++y) {
        for (int x = -1; x <= geometry.width; ++x) {
          if (touches({x, y}, a, b) && !free.isFree({x, y})) sees = false;
        }
      }
      ASSERT_EQ(free.canSee(a, b), sees) << "trial " << trial << " sight " << i;
      ASSERT_EQ(free.canSee(b, a), sees) << "trial " << trial << " sight " << i;
      seen += sees ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 1000);
}

TEST(FreeSpace, RadiusEqualToTheDistanceIsTooClose) {
  const MapGeometry geometry{11, 3, 0.05, {}};
  std::vector<std::uint8_t> obstacles(geometry.pixelCount());
  obstacles[geometry.index({0, 1})] = 1;
  const FreeSpace free = freeSpace(geometry, obstacles, 0.2);
  EXPECT_FALSE(free.isFree({4, 1}));
  EXPECT_TRUE(free.isFree({5, 1}));
  // A message's resolution is a float32: 0.05f is a little more than 0.05.
  const MapGeometry rounded{11, 3, static_cast<double>(0.05F), {}};
  EXPECT_FALSE(freeSpace(rounded, obstacles, 0.2).isFree({4, 1}));
  EXPECT_TRUE(freeSpace(rounded, obstacles, 0.2).isFree({5, 1}));
}

TEST(FreeSpace, OutermostRingIsNeverFreeButNoObstacle) {
  const MapGeometry geometry{5, 5, 1, {}};
  const FreeSpace free = freeSpace(geometry, std::vector<std::uint8_t>(25), 3);
  int count = 0;
  for (std::size_t i = 0; i < 25; ++i) count += free.isFree(geometry.pixel(i)) ? 1 : 0;
  EXPECT_EQ(count, 9);
}

TEST(FreeSpace, DiagonalNeedsBothPixelsBeside) {
  const MapGeometry geometry{4, 4, 1, {}};
  std::vector<std::uint8_t> obstacles(16);
  const auto sees = [&] {
    return freeSpace(geometry, obstacles, 0).canSee(centerOf({1, 1}), centerOf({2, 2}));
  };
  EXPECT_TRUE(sees());
  obstacles[geometry.index({1, 2})] = 1;
  EXPECT_FALSE(sees());
}

TEST(WalkTouched, VisitsTheTouchedPixelsEachOnce) {
  std::mt19937 random(3);
  const MapGeometry geometry{20, 20, 1, {}};
  for (int trial = 0; trial < 500; ++trial) {
    const FinePoint a = randomPoint(random, geometry, trial % 3);
    const FinePoint b = randomPoint(random, geometry, (trial / 3) % 3);
    std::vector<Pixel> walked;
    walkTouched(a, b, [&](Pixel p) {
      walked.push_back(p);
      return true;
    });
    std::size_t expected = 0;
    for (int y = -2; y < 23; ++y) {
      for (int x = -2; x < 23; ++x) {
        if (!touches({x, y}, a, b)) continue;
        ++expected;
        ASSERT_EQ(std::count(walked.begin(), walked.end(), Pixel{x, y}), 1) << "trial " << trial;
      }
    }
    ASSERT_EQ(walked.size(), expected);
  }
}

}  // namespace
}  // namespace agrid::planning
