// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_end.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

/// Straight, or around any turning point in sight at which a shortest path can bend.
float shortestTo(const RoadSample& s, const RoadEnd& end, std::size_t rank) {
  const RegionRoads& roads = end.roads();
  const FinePoint crossing = s.portalsOf(end.region())[rank]->crossing();
  float least = kUnreachable;
  if (s.free().canSee(end.point(), crossing)) {
    least = static_cast<float>(distancePx(end.point(), crossing));
  }
  for (std::size_t i = 0; i < roads.points().size(); ++i) {
    const TurningPoint& point = roads.points()[i];
    if (!point.isTangentTo(end.point()) || !s.free().canSee(end.point(), point.at)) continue;
    const auto leg = static_cast<float>(distancePx(end.point(), point.corner()));
    least = std::min(least, leg + roads.lengthsTo(Measure::kPath, rank)[i]);
  }
  return least;
}

void expectRoad(const RoadSample& s, RoadEnd& end, std::size_t rank, float length) {
  const RegionRoads& roads = end.roads();
  double sum = 0;
  FinePoint here = end.point();
  for (RegionRoads::Node node = end.next(rank);; node = roads.next(rank, node)) {
    ASSERT_TRUE(s.free().canSee(here, roads.at(node)));
    sum += distancePx(here, roads.at(node));
    here = roads.at(node);
    if (!roads.isTurningPoint(node)) break;
  }
  EXPECT_TRUE(here == s.portalsOf(end.region())[rank]->crossing());
  EXPECT_NEAR(sum, length, 1e-2);
}

TEST(RoadEnd, LengthsAreTheShortestOverAllThatIsInSight) {
  std::mt19937 random(51);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    for (int i = 0; i < 5 && !pixels.empty(); ++i) {
      const Pixel p = pixels[random() % pixels.size()];
      RoadEnd end(s.free(), s.roadmap(), centerOf(p), s.regionAt(p));
      for (std::size_t rank = 0; rank < end.roads().portalCount(); ++rank) {
        const float hoped = end.hopedLength(Measure::kPath, rank);
        const float length = end.length(Measure::kPath, rank);
        const float expected = shortestTo(s, end, rank);
        ASSERT_EQ(length == kUnreachable, expected == kUnreachable);
        if (length == kUnreachable) continue;
        ASSERT_NEAR(length, expected, 1e-3);
        EXPECT_LE(hoped, length);
        EXPECT_LE(end.straightLength(Measure::kPath, rank), hoped + 1e-3);
        EXPECT_LE(end.straightLength(Measure::kLeast, rank),
                  end.length(Measure::kLeast, rank) + 1e-3);
        expectRoad(s, end, rank, length);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

/// To places for which some shortest path of all stays within the region.
TEST(RoadEnd, LeastLengthsAreNotGreaterThanAnyShortestPathToTheBorder) {
  std::mt19937 random(52);
  int compared = 0;
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    if (pixels.empty()) continue;
    const Pixel p = pixels[random() % pixels.size()];
    const std::uint32_t region = s.regionAt(p);
    RoadEnd end(s.free(), s.roadmap(), centerOf(p), region);
    const test::BestLength inside([&](Pixel q) { return s.regionAt(q) == region; }, s.geometry());
    const test::BestLength all([&](Pixel q) { return s.free().isFree(q); }, s.geometry());
    const auto portals = s.portalsOf(region);
    for (std::size_t rank = 0; rank < portals.size(); ++rank) {
      const float least = end.length(Measure::kLeast, rank);
      for (const auto& piece : test::piecesOf(s.regions(), s.geometry(), *portals[rank])) {
        const Pixel place = piece.ends()[random() % 2];
        const Pixel start{2 * p.x + 1, 2 * p.y + 1};
        const double length = inside.toNearestPoint(start, {place});
        if (std::isinf(length) || length > all.toNearestPoint(start, {place}) + 1e-9) continue;
        ASSERT_LE(least, length + 1e-3) << "to half pixel " << place.x << "," << place.y;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

}  // namespace
}  // namespace agrid::planning
