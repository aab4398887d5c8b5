// SPDX-License-Identifier: BSD-3-Clause
// Bounds and lengths of roads against the shortest way of all, where regions are small and their
// borders of any shape.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
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

TEST(LengthBound, NoWayToAnAreaIsShorter) {
  std::mt19937 random(72);
  Comparison compared;
  for (int trial = 0; trial < 1200; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<Pixel> pixels = s.freePixels();
    if (pixels.empty()) continue;
    const Pixel p = pixels[random() % pixels.size()];
    Target target;
    target.label = s.level->labelOf(s.regionAt(pixels[random() % pixels.size()]));
    std::vector<Pixel> goals;
    for (const Pixel q : pixels) {
      if (s.level->labelOf(s.regionAt(q)) != target.label) continue;
      target.box.add(q);
      goals.push_back(q);
    }
    for (std::uint32_t i = 0; i < s.regions().nodeCount(); ++i) {
      const bool is_reached = s.regions().componentOf(i) == s.regions().componentOf(s.regionAt(p));
      if (is_reached && s.level->labelOf(i) == target.label) target.regions.push_back(i);
    }
    if (target.regions.empty()) continue;
    const test::BestLength best([&](Pixel q) { return s.free().isFree(q); }, s.geometry());
    compared.add(tautRoad(s, p, target), best.toNearest(p, goals), 0);
    if (HasFailure()) return;
  }
  ASSERT_GT(compared.count, 300);
  EXPECT_LT(compared.sum_lengths / compared.count, 1.01);
  RecordProperty("lengths", std::to_string(compared.sum_lengths / compared.count));
}

}  // namespace
}  // namespace agrid::planning
