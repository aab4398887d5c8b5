// SPDX-License-Identifier: BSD-3-Clause
#include "planning/turning_point.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

test::RoadSample drawn(const std::vector<std::string>& rows) {
  return test::roadSample(test::sceneOf(rows), {});
}

TEST(TurningPoints, LieOppositeTheOnlyPixelOfFourThatIsNotFree) {
  std::mt19937 random(31);
  std::size_t found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const test::RoadSample s = test::randomRoadSample(random);
    std::vector<TurningPoint> points = turningPoints(s.free(), {});
    found += points.size();
    for (const Pixel p : s.freePixels()) {
      for (const int dx : {-1, 1}) {
        for (const int dy : {-1, 1}) {
          const bool is_corner = s.free().isFree({p.x + dx, p.y}) &&
                                 s.free().isFree({p.x, p.y + dy}) &&
                                 !s.free().isFree({p.x + dx, p.y + dy});
          if (!is_corner) continue;
          const FinePoint corner{p.x * kFine + dx * kFine / 2, p.y * kFine + dy * kFine / 2};
          const auto point = std::find_if(points.begin(), points.end(), [&](const auto& t) {
            return t.corner() == corner && t.blocked_x == dx && t.blocked_y == dy;
          });
          ASSERT_NE(point, points.end()) << "trial " << trial;
          EXPECT_TRUE(point->at.pixel() == p);
          EXPECT_NEAR(distancePx(point->at, corner), 0, 1e-4);
          points.erase(point);
        }
      }
    }
    ASSERT_TRUE(points.empty()) << "trial " << trial;
  }
  EXPECT_GT(found, 1000U);
}

TEST(TurningPoints, APixelAloneHasFour) {
  const test::RoadSample s = drawn({".......", ".......", "...#...", ".......", "......."});
  EXPECT_EQ(turningPoints(s.free(), {}).size(), 4U);
}

/// The whole quarter of the plane beyond a corner is not free: exactly the lines through the point
/// that are not tangent run into it, on this or on the far side of the point.
TEST(TurningPoint, IsTangentToWhatLinesPastTheCornerLeadTo) {
  std::mt19937 random(32);
  for (const int quarter : {0, 1, 2, 3}) {
    std::vector<std::string> rows(41, std::string(41, '.'));
    for (int y = 0; y < 21; ++y) {
      for (int x = 0; x < 21; ++x) {
        rows[static_cast<std::size_t>(quarter < 2 ? y : 40 - y)]
            [static_cast<std::size_t>(quarter % 2 == 0 ? x : 40 - x)] = '#';
      }
    }
    const test::RoadSample s = drawn(rows);
    const std::vector<TurningPoint> points = turningPoints(s.free(), {});
    ASSERT_EQ(points.size(), 1U);
    const TurningPoint& point = points.front();
    int tangents = 0;
    for (int i = 0; i < 400; ++i) {
      std::uniform_int_distribution<int> offset(-8, 8);
      const FinePoint step{offset(random) * kFine / 2, offset(random) * kFine / 2};
      if (step == FinePoint{}) continue;
      const FinePoint other{point.at.x + step.x, point.at.y + step.y};
      const FinePoint behind{point.at.x - step.x, point.at.y - step.y};
      const bool passes = s.free().canSee(point.at, other) && s.free().canSee(point.at, behind);
      EXPECT_EQ(point.isTangentTo(other), passes) << step.x << " " << step.y;
      EXPECT_EQ(point.isTangentTo(behind), passes);
      tangents += passes ? 1 : 0;
    }
    EXPECT_GT(tangents, 100);
  }
}

}  // namespace
}  // namespace agrid::planning
