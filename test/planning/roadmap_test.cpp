// SPDX-License-Identifier: BSD-3-Clause
#include "planning/roadmap.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

/// Distance of a point to the nearest pixel of a region, of columns or of rows [px].
double distanceTo(const RoadSample& s, std::uint32_t region, Pixel p) {
  double least = 1e9;
  for (const Pixel q : s.freePixels()) {
    if (s.regionAt(q) != region) continue;
    least = std::min<double>(least, std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)));
  }
  return least;
}

TEST(Roadmap, RegionsHaveAllTurningPointsWithinReachOfTheirPaths) {
  std::mt19937 random(57);
  int outside = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const RoadSample s = test::randomRoadSample(random);
    const std::vector<TurningPoint> points = turningPoints(s.free(), {});
    for (std::uint32_t region = 0; region < s.regions().nodeCount(); ++region) {
      std::set<std::pair<std::int64_t, std::int64_t>> listed;
      for (const TurningPoint& p : s.roadmap().roads(region).points()) {
        EXPECT_TRUE(listed.emplace(p.at.x, p.at.y).second) << "listed twice";
      }
      double reach = 0;
      for (const Portal* portal : s.portalsOf(region)) reach = std::max(reach, portal->reach);
      for (const TurningPoint& p : points) {
        if (distanceTo(s, region, p.at.pixel()) > reach) continue;
        ASSERT_EQ(listed.count({p.at.x, p.at.y}), 1U) << "trial " << trial << " region " << region;
        outside += s.regionAt(p.at.pixel()) == region ? 0 : 1;
      }
    }
  }
  EXPECT_GT(outside, 300);
}

TEST(Roadmap, RegionsArePiecesOfOneAreaAndKnowTheirPortalsByRank) {
  std::mt19937 random(58);
  for (int trial = 0; trial < 200; ++trial) {
    const RoadSample s = test::randomRoadSample(random);
    for (const Pixel p : s.freePixels()) {
      ASSERT_EQ(s.level->regionLabels().labelOf(s.regionAt(p)),
                s.map->area_map.pixel_labels[s.geometry().index(p)]);
    }
    for (std::uint32_t region = 0; region < s.regions().nodeCount(); ++region) {
      const auto portals = s.regions().portalsOf(region);
      const RegionRoads& roads = s.roadmap().roads(region);
      for (const std::uint32_t portal : portals) {
        const Portal& p = s.regions().portals()[portal];
        const std::size_t rank = s.roadmap().rankOf(portal, p.sideOf(region));
        ASSERT_LT(rank, roads.portalCount());
        EXPECT_EQ(portals.begin()[rank], portal);
        EXPECT_TRUE(roads.at(roads.nodeOfPortal(rank)) == p.crossing());
      }
    }
  }
}

}  // namespace
}  // namespace agrid::planning
