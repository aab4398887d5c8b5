// SPDX-License-Identifier: BSD-3-Clause
// Bounds and lengths of roads against the shortest way of all, where regions are small and their
// borders of any shape.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
#include "planning/endpoints.h"
#include "planning/road_search.h"
#include "planning/sample_roads.h"
#include "planning/taut.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

/// Paths bend on a lattice of 1/32768 pixel, a bound may take that for granted [px].
constexpr double kLattice = 1e-3;

/// How roads compare with the shortest ways.
struct Comparison {
  int count = 0;
  double sum_bounds = 0;  ///< parts of the shortest length
  double sum_lengths = 0;
  double worst = 0;

  void add(const Road& road, double best, double straight) {
    EXPECT_LE(road.length_bound_px, best + kLattice);
    EXPECT_GE(road.length_bound_px, straight - kLattice);
    EXPECT_GE(lengthPx(road), best - 1e-9);
    if (best == 0 || best < straight + kLattice) return;
    sum_bounds += road.length_bound_px / best;
    sum_lengths += lengthPx(road) / best;
    worst = std::max(worst, lengthPx(road) / best);
    ++count;
  }
};

Road tautRoad(const RoadSample& s, Pixel start, const Target& target) {
  Road road = RoadSearch(*s.level).find({centerOf(start), s.regionAt(start), &target}, {});
  pullTaut(s.free(), s.roadmap(), road);
  return road;
}

TEST(LengthBound, NoWayToAPointIsShorter) {
  std::mt19937 random(71);
  Comparison compared;
  for (int trial = 0; trial < 1500; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    const test::BestLength best([&](Pixel p) { return s.free().isFree(p); }, s.geometry());
    for (int i = 0; i < 3 && !pixels.empty(); ++i) {
      const Pixel p = pixels[random() % pixels.size()];
      const Pixel q = pixels[random() % pixels.size()];
      if (s.regions().componentOf(s.regionAt(p)) != s.regions().componentOf(s.regionAt(q))) {
        continue;
      }
      Target target;
      target.point = centerOf(q);
      target.regions = {s.regionAt(q)};
      target.box.add(q);
      compared.add(tautRoad(s, p, target), best.toNearest(p, {q}),
                   std::hypot(p.x - q.x, p.y - q.y));
    }
    if (HasFailure()) return;
  }
  ASSERT_GT(compared.count, 300);
  EXPECT_GT(compared.sum_bounds / compared.count, 0.85);
  EXPECT_LT(compared.sum_lengths / compared.count, 1.01);
  EXPECT_LT(compared.worst, 1.25);
  RecordProperty("bounds", std::to_string(compared.sum_bounds / compared.count));
  RecordProperty("lengths", std::to_string(compared.sum_lengths / compared.count));
  RecordProperty("worst", std::to_string(compared.worst));
}

/// The same regions under other areas, so that some lie in several.
void divideAnew(std::mt19937& random, RoadSample& s) {
  test::Scene other = s.scene;
  test::addAreasOfAnyShape(random, other);
  s.map = test::mapOf(other);
  s.level = std::make_unique<const RadiusLevel>(*s.level, s.map->area_map.pixel_labels, true);
}

void compareWaysToAreas(std::mt19937& random, const RoadSample& s, Comparison& compared) {
  const std::vector<Pixel> pixels = s.freePixels();
  if (pixels.empty()) return;
  const auto labelAt = [&](Pixel p) { return s.level->labels()[s.geometry().index(p)]; };
  const Pixel p = pixels[random() % pixels.size()];
  const std::uint16_t label = labelAt(pixels[random() % pixels.size()]);
  std::vector<Pixel> goals;
  std::copy_if(pixels.begin(), pixels.end(), std::back_inserter(goals),
               [&](Pixel q) { return labelAt(q) == label; });
  const std::uint32_t component = s.regions().componentOf(s.regionAt(p));
  const Target all = areaTarget(*s.level, label);
  if (componentsOf(all, s.regions()).count(component) == 0) return;
  const Target target = reachablePart(all, s.regions(), component);
  const Road road = tautRoad(s, p, target);
  EXPECT_EQ(labelAt(road.corners.back().at.pixel()), label);
  for (std::size_t i = 1; i < road.corners.size(); ++i) {
    EXPECT_TRUE(s.free().canSee(road.corners[i - 1].at, road.corners[i].at)) << "leg " << i;
  }
  const test::BestLength best([&](Pixel q) { return s.free().isFree(q); }, s.geometry());
  compared.add(road, best.toNearest(p, goals), 0);
}

TEST(LengthBound, NoWayToAnAreaIsShorter) {
  std::mt19937 random(72);
  Comparison compared;
  for (int trial = 0; trial < 1200; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    compareWaysToAreas(random, test::randomRoadSample(random), compared);
    if (HasFailure()) return;
  }
  ASSERT_GT(compared.count, 300);
  EXPECT_LT(compared.sum_lengths / compared.count, 1.01);
  RecordProperty("lengths", std::to_string(compared.sum_lengths / compared.count));
}

TEST(LengthBound, NoWayToAnAreaThatSharesRegionsWithOthersIsShorter) {
  std::mt19937 random(73);
  Comparison compared;
  for (int trial = 0; trial < 1500; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    RoadSample s = test::randomRoadSample(random);
    for (int i = 0; i < 2; ++i) {
      divideAnew(random, s);
      compareWaysToAreas(random, s, compared);
      if (HasFailure()) return;
    }
  }
  ASSERT_GT(compared.count, 500);
  EXPECT_GT(compared.sum_bounds / compared.count, 0.5);  // ways are as short as the borders
  EXPECT_LT(compared.sum_lengths / compared.count, 1.02);
  RecordProperty("bounds", std::to_string(compared.sum_bounds / compared.count));
  RecordProperty("lengths", std::to_string(compared.sum_lengths / compared.count));
  RecordProperty("worst", std::to_string(compared.worst));
}

}  // namespace
}  // namespace agrid::planning
