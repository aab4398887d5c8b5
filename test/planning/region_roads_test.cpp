// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_roads.h"

#include <cmath>
#include <map>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "planning/best_length.h"
#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

/// Whether a point is not on the other region's side of a portal's border, where that is a line.
bool liesOnSide(const Portal& portal, std::uint32_t region, FinePoint p) {
  if (!portal.straight) return true;
  const Pixel own = portal.nodes[0] == region ? portal.middle : portal.beyond;
  const FinePoint border = portal.crossing();
  const FinePoint center = centerOf(own);
  return center.x == border.x ? (p.y - border.y) * (center.y - border.y) >= 0
                              : (p.x - border.x) * (center.x - border.x) >= 0;
}

FinePoint cornerAt(int x, int y) { return {x * kFine - kFine / 2, y * kFine - kFine / 2}; }

bool liesOnSide(const Portal& portal, std::uint32_t region, const Portal& other) {
  return liesOnSide(portal, region, cornerAt(other.border.low.x, other.border.low.y)) ||
         liesOnSide(portal, region, cornerAt(other.border.high.x, other.border.high.y));
}

bool joinTheSame(const Portal& a, const Portal& b) {
  return a.nodes == b.nodes || (a.nodes[0] == b.nodes[1] && a.nodes[1] == b.nodes[0]);
}

/// Whether a leg between two nodes of a region's roads leads into the region from the borders it
/// ends at, and not there and back over the same border.
bool isOfRegion(const RoadSample& s, std::uint32_t region, std::size_t from, std::size_t to) {
  const RegionRoads& roads = s.roadmap().roads(region);
  const auto portals = s.portalsOf(region);
  const std::size_t count = roads.points().size();
  if (from >= count && to >= count) {
    const Portal& a = *portals[from - count];
    const Portal& b = *portals[to - count];
    return !joinTheSame(a, b) && liesOnSide(a, region, b) && liesOnSide(b, region, a);
  }
  for (const auto& [portal, other] : {std::pair{from, to}, std::pair{to, from}}) {
    if (portal >= count && other < count &&
        !liesOnSide(*portals[portal - count], region, roads.points()[other].corner())) {
      return false;
    }
  }
  return true;
}

/// Length of every sight between two nodes, whether a shortest path can bend at its ends or not.
double legOf(const RoadSample& s, std::uint32_t region, std::size_t from, std::size_t to) {
  const RegionRoads& roads = s.roadmap().roads(region);
  const auto portals = s.portalsOf(region);
  const std::size_t count = roads.points().size();
  const auto place = [&](std::size_t node) {
    return node < count ? roads.points()[node].corner() : portals[node - count]->crossing();
  };
  const auto node = [](std::size_t i) { return static_cast<RegionRoads::Node>(i); };
  return s.free().canSee(roads.at(node(from)), roads.at(node(to)))
             ? distancePx(place(from), place(to))
             : kEverywhere;
}

TEST(RegionRoads, PathsAreTheShortestOverAllSights) {
  std::mt19937 random(41);
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const RoadSample s = test::randomRoadSample(random);
    for (std::uint32_t region = 0; region < s.regions().nodeCount(); ++region) {
      const RegionRoads& roads = s.roadmap().roads(region);
      const std::size_t points = roads.points().size();
      const std::size_t nodes = points + roads.portalCount();
      for (std::size_t rank = 0; rank < roads.portalCount(); ++rank) {
        const std::size_t root = points + rank;
        const auto anyLeg = [&](std::size_t i, std::size_t k) {
          return i >= points && i != root ? kEverywhere : legOf(s, region, i, k);
        };
        const auto lengths = test::lengthsFrom(root, nodes, [&](std::size_t i, std::size_t k) {
          return isOfRegion(s, region, i, k) ? anyLeg(i, k) : kEverywhere;
        });
        const auto shortest = test::lengthsFrom(root, nodes, anyLeg);
        for (std::size_t i = 0; i < nodes; ++i) {
          if (i == root) continue;
          const double stored = roads.lengthsTo(Measure::kPath, rank)[i];
          const auto text = [&] {
            return "trial " + std::to_string(trial) + " from " + std::to_string(i) + " of " +
                   std::to_string(points);
          };
          // Only what bends at a point is stored for it, which may be longer or nothing at all.
          ASSERT_TRUE(std::isinf(stored) || stored > lengths[i] - 1e-3) << text();
          // A path that is only the shortest of the region's legs need not be taut.
          if (i < points || shortest[i] < lengths[i] - 1e-6) continue;
          ASSERT_EQ(std::isinf(stored), std::isinf(lengths[i])) << text();
          if (std::isinf(stored)) continue;
          ASSERT_NEAR(stored, lengths[i], 1e-3) << text();
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(RegionRoads, NextNodesLeadToThePortalInSightOfEachOther) {
  std::mt19937 random(42);
  for (int trial = 0; trial < 100; ++trial) {
    const RoadSample s = test::randomRoadSample(random);
    for (std::uint32_t region = 0; region < s.regions().nodeCount(); ++region) {
      const RegionRoads& roads = s.roadmap().roads(region);
      const std::size_t points = roads.points().size();
      const auto corner = [&](RegionRoads::Node node) {
        return node < points ? roads.points()[node].corner() : roads.at(node);
      };
      for (std::size_t rank = 0; rank < roads.portalCount(); ++rank) {
        const RegionRoads::Node root = roads.nodeOfPortal(rank);
        for (std::size_t i = 0; i < points + roads.portalCount(); ++i) {
          const float stored = roads.lengthsTo(Measure::kPath, rank)[i];
          if (!(stored < kUnreachable)) continue;
          double length = 0;
          for (auto node = static_cast<RegionRoads::Node>(i); node != root;) {
            const RegionRoads::Node next = roads.next(rank, node);
            ASSERT_TRUE(next == root || roads.isTurningPoint(next));
            ASSERT_TRUE(s.free().canSee(roads.at(node), roads.at(next)));
            length += distancePx(corner(node), corner(next));
            ASSERT_LE(length, stored + 1e-3);
            node = next;
          }
          EXPECT_NEAR(length, stored, 1e-3);
        }
      }
    }
  }
}

/// Places on the borders of a region: corners of pixels and the middles between them, with the
/// portals that they belong to, by rank.
std::map<std::pair<int, int>, std::vector<std::size_t>> placesOf(const RoadSample& s,
                                                                 std::uint32_t region) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> places;
  const auto portals = s.portalsOf(region);
  for (std::size_t rank = 0; rank < portals.size(); ++rank) {
    for (const auto& piece : test::piecesOf(s.regions(), s.geometry(), *portals[rank])) {
      for (const Pixel p : {piece.middle(), piece.ends()[0], piece.ends()[1]}) {
        places[{p.x, p.y}].push_back(rank);
      }
    }
  }
  return places;
}

/// Between any portal at one place and any at another; none if that way is straight there and back
/// over the same border.
std::optional<float> leastBetween(const RoadSample& s, std::uint32_t region,
                                  const std::vector<std::size_t>& from,
                                  const std::vector<std::size_t>& to, bool is_straight) {
  const auto portals = s.portalsOf(region);
  const RegionRoads& roads = s.roadmap().roads(region);
  float least = kUnreachable;
  for (const std::size_t a : from) {
    for (const std::size_t b : to) {
      if (is_straight && joinTheSame(*portals[a], *portals[b])) return std::nullopt;
      least = std::min(least, roads.lengthsTo(Measure::kLeast, a)[roads.points().size() + b]);
    }
  }
  return least;
}

/// Of all pairs of places for which some shortest path of all stays within the region.
TEST(RegionRoads, LeastLengthsAreNotGreaterThanAnyShortestPathFromBorderToBorder) {
  std::mt19937 random(43);
  int compared = 0;
  for (int trial = 0; trial < 250; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    for (std::uint32_t region = 0; region < s.regions().nodeCount(); ++region) {
      const auto places = placesOf(s, region);
      const test::BestLength inside([&](Pixel p) { return s.regionAt(p) == region; }, s.geometry());
      const test::BestLength all([&](Pixel p) { return s.free().isFree(p); }, s.geometry());
      for (int i = 0; i < 40 && !places.empty(); ++i) {
        const auto& [from, a] = *std::next(places.begin(), random() % places.size());
        const auto& [to, b] = *std::next(places.begin(), random() % places.size());
        const Pixel p{from.first, from.second};
        const Pixel q{to.first, to.second};
        const double length = inside.toNearestPoint(p, {q});
        if (std::isinf(length) || length > all.toNearestPoint(p, {q}) + 1e-9) continue;
        const bool is_straight = length < std::hypot(p.x - q.x, p.y - q.y) / 2 + 1e-9;
        const std::optional<float> least = leastBetween(s, region, a, b, is_straight);
        if (!least) continue;
        EXPECT_LE(*least, length + 1e-3) << "region " << region << ", half pixels " << p.x << ","
                                         << p.y << " to " << q.x << "," << q.y;
        ++compared;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, 1000);
}

TEST(RegionRoads, BorderToBorderAcrossAHallIsAsShortAsTheHall) {
  std::vector<std::string> rows(12, std::string(20, '.'));
  test::Scene scene = test::sceneOf(rows);
  scene.areas.assign(12, "AAAAAABBBBBBBBCCCCCC");
  const RoadSample s = test::roadSample(std::move(scene), {});
  const std::uint32_t hall = s.regionAt({9, 5});
  const RegionRoads& roads = s.roadmap().roads(hall);
  const auto portals = s.portalsOf(hall);
  for (std::size_t i = 0; i < portals.size(); ++i) {
    for (std::size_t k = 0; k < portals.size(); ++k) {
      const FinePoint a = portals[i]->crossing();
      const FinePoint b = portals[k]->crossing();
      if (a.x == b.x) continue;
      EXPECT_NEAR(roads.lengthsTo(Measure::kPath, i)[k], distancePx(a, b), 1e-4);
      const PixelBox& low = (a.y < b.y ? portals[i] : portals[k])->border;
      const PixelBox& high = (a.y < b.y ? portals[k] : portals[i])->border;
      const double rise = std::max(0, high.low.y - low.high.y);
      EXPECT_NEAR(roads.lengthsTo(Measure::kLeast, i)[k], std::hypot(8, rise), 0.2);
    }
  }
}

}  // namespace
}  // namespace agrid::planning
