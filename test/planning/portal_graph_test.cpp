// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "planning/cell_lookup.h"
#include "planning/obstacles.h"
#include "planning/plan_oracle.h"
#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

struct Sample {
  test::Scene scene;
  std::shared_ptr<const SemanticMap> map;
  std::unique_ptr<FreeSpace> free;
  std::unique_ptr<PortalGraph> graph;
};

/// Of a pixel; what the classes of the graph below are.
std::uint32_t cellOf(const CellLookup& cells, Pixel p) { return cells.cellsAlong({p}).front(); }

Sample randomSample(std::mt19937& random) {
  Sample sample;
  std::uniform_int_distribution<int> side(3, 30);
  const MapGeometry geometry{side(random), side(random), 0.05, {{1, -2}, side(random) * 0.2}};
  sample.scene.grid = test::randomPlan(random, geometry);
  sample.scene.x_lines = side(random) / 3;
  sample.scene.y_lines = side(random) / 3;
  sample.scene.grid_yaw = side(random) % 2 == 0 ? 0 : 0.1 * side(random);
  sample.map = test::mapOf(sample.scene);
  const Obstacles obstacles(*sample.map, true);
  sample.free =
      std::make_unique<FreeSpace>(geometry,
                                  std::make_shared<const planning::SquaredDistances>(
                                      obstacleDistances(geometry, obstacles, Clearance::kCostmap)),
                                  0.05 * (side(random) % 3));
  const CellLookup cells(geometry, sample.map->grid());
  sample.graph = std::make_unique<PortalGraph>(
      *sample.free,
      [&](int y, std::vector<std::uint32_t>& row) {
        for (std::size_t x = 0; x < row.size(); ++x) {
          row[x] = cellOf(cells, {static_cast<int>(x), y});
        }
      },
      StopCheck{}, side(random) % 2 == 0 ? PortalCut::kWholeRuns : PortalCut::kParts);
  return sample;
}

/// Numbers the connected groups of pixels by flood fill; neighbours are joined where `joins`.
template <typename Joins>
std::vector<int> floodGroups(const MapGeometry& g, const FreeSpace& free, const Joins& joins) {
  std::vector<int> group(g.pixelCount(), -1);
  int next = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] >= 0 || !free.isFree(g.pixel(i))) continue;
    std::vector<Pixel> open{g.pixel(i)};
    group[i] = next;
    while (!open.empty()) {
      const Pixel p = open.back();
      open.pop_back();
      for (const Pixel q :
           {Pixel{p.x + 1, p.y}, Pixel{p.x - 1, p.y}, Pixel{p.x, p.y + 1}, Pixel{p.x, p.y - 1}}) {
        if (!free.isFree(q) || group[g.index(q)] >= 0 || !joins(p, q)) continue;
        group[g.index(q)] = next;
        open.push_back(q);
      }
    }
    ++next;
  }
  return group;
}

void expectSameGroups(const std::vector<int>& expected, const std::vector<std::uint32_t>& found) {
  std::map<int, std::uint32_t> there;
  std::map<std::uint32_t, int> back;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(expected[i] < 0, found[i] == kNoNode);
    if (expected[i] < 0) continue;
    ASSERT_EQ(there.emplace(expected[i], found[i]).first->second, found[i]);
    ASSERT_EQ(back.emplace(found[i], expected[i]).first->second, expected[i]);
  }
}

TEST(PortalGraph, NodesAndComponentsAreThoseOfAFloodFill) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Sample s = randomSample(random);
    const MapGeometry& g = s.scene.grid.geometry;
    const CellLookup cells(g, s.map->grid());
    std::vector<std::uint32_t> nodes(g.pixelCount());
    std::vector<std::uint32_t> components(g.pixelCount(), kNoNode);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i] = s.graph->nodeAt(i);
      if (nodes[i] == kNoNode) continue;
      components[i] = s.graph->componentOf(nodes[i]);
      ASSERT_EQ(s.graph->classOf(nodes[i]), cellOf(cells, g.pixel(i)));
    }
    expectSameGroups(
        floodGroups(g, *s.free,
                    [&](Pixel p, Pixel q) { return cellOf(cells, p) == cellOf(cells, q); }),
        nodes);
    expectSameGroups(floodGroups(g, *s.free, [](Pixel, Pixel) { return true; }), components);
    if (HasFailure()) return;
  }
}

TEST(PortalGraph, PortalsHoldEveryPairOfNeighboursInTwoNodes) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Sample s = randomSample(random);
    const MapGeometry& g = s.scene.grid.geometry;
    for (std::size_t i = 0; i < g.pixelCount(); ++i) {
      const Pixel p = g.pixel(i);
      for (const Pixel q : {Pixel{p.x + 1, p.y}, Pixel{p.x, p.y + 1}}) {
        if (!s.free->isFree(p) || !s.free->isFree(q)) continue;
        const std::uint32_t a = s.graph->nodeAt(g.index(p));
        const std::uint32_t b = s.graph->nodeAt(g.index(q));
        if (a == b) continue;
        int holders = 0;
        for (const std::uint32_t k : s.graph->portalsOf(a)) {
          const Portal& portal = s.graph->portals()[k];
          if (portal.other(a) != b) continue;
          holders += portal.box.low.x <= p.x && portal.box.low.y <= p.y &&
                     portal.box.high.x >= q.x && portal.box.high.y >= q.y;
        }
        ASSERT_GE(holders, 1) << "trial " << trial;
      }
    }
  }
}

using Place = std::pair<int, int>;

Place placeOf(Pixel half_pixels) { return {half_pixels.x, half_pixels.y}; }

/// Lengths along the border pieces of a portal from its crossing [px], by breadth-first search.
std::map<Place, double> lengthsAlong(const std::vector<test::BorderPiece>& pieces,
                                     const Portal& portal) {
  const Point2 crossing = coordinates(portal.crossing()) + Point2(0.5, 0.5);
  std::map<Place, double> lengths{{{static_cast<int>(std::lround(2 * crossing.x())),
                                    static_cast<int>(std::lround(2 * crossing.y()))},
                                   0}};
  for (bool changed = true; changed;) {
    changed = false;
    for (const test::BorderPiece& piece : pieces) {
      const auto step = [&](Place from, Place to) {
        const auto known = lengths.find(from);
        if (known == lengths.end()) return;
        const double length = known->second + 0.5;
        const auto [there, is_new] = lengths.emplace(to, length);
        if (!is_new && there->second <= length) return;
        there->second = length;
        changed = true;
      };
      for (const Pixel end : piece.ends()) {
        step(placeOf(piece.middle()), placeOf(end));
        step(placeOf(end), placeOf(piece.middle()));
      }
    }
  }
  return lengths;
}

TEST(Portal, ReachesEveryPlaceOfItsBorderAndIsStraightIfAllItsPairsLieAlike) {
  std::mt19937 random(61);
  int bent = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Sample s = randomSample(random);
    for (const Portal& portal : s.graph->portals()) {
      const auto pieces = test::piecesOf(*s.graph, s.scene.grid.geometry, portal);
      double farthest = 0;
      for (const auto& [place, length] : lengthsAlong(pieces, portal)) {
        farthest = std::max(farthest, length);
        const Point2 p = (Point2(place.first, place.second) - Point2(1, 1)) / 2;
        EXPECT_EQ(portal.distanceToBorder(finePoint(p)), 0);
      }
      EXPECT_GE(portal.reach, farthest);
      const bool is_alike = std::all_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
        return (piece.low.y == piece.high.y) == (portal.middle.y == portal.beyond.y) &&
               s.graph->nodeAt(s.scene.grid.geometry.index(piece.low)) == portal.nodes[0];
      });
      if (portal.straight) {
        EXPECT_TRUE(is_alike);
        EXPECT_LE(portal.reach, static_cast<double>(pieces.size()) / 2 + 0.51);
      }
      bent += is_alike ? 0 : 1;
    }
  }
  EXPECT_GT(bent, 100);
}

TEST(Portal, StraightBordersLeadToTheirOwnSideOnly) {
  std::mt19937 random(62);
  int turned_down = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Sample s = randomSample(random);
    for (const Portal& portal : s.graph->portals()) {
      const Pixel step{portal.beyond.x - portal.middle.x, portal.beyond.y - portal.middle.y};
      for (const int d : {-5, -1, 0, 1, 5}) {
        // Beyond the border by d, and anywhere along it.
        const std::int64_t along = (static_cast<int>(random() % 21) - 10) * kFine;
        const FinePoint p{portal.crossing().x + d * step.x * kFine + step.y * along,
                          portal.crossing().y + d * step.y * kFine + step.x * along};
        EXPECT_EQ(portal.canLeadTo(p, portal.nodes[0]), !portal.straight || d <= 0);
        EXPECT_EQ(portal.canLeadTo(p, portal.nodes[1]), !portal.straight || d >= 0);
        turned_down += portal.straight && d != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(turned_down, 1000);
}

/// A border that winds back is longer than its box is wide and high.
TEST(Portal, ReachOfAWindingBorderIsItsLength) {
  test::Scene scene =
      test::sceneOf({".......", ".......", ".......", ".......", ".......", "......."});
  scene.areas = {"AAAAAAA", "AAAAAAA", "ABAAABA", "ABBABBB", "BBBBBBB", "BBBBBBB"};
  const test::RoadSample s = test::roadSample(scene, {});
  const PortalGraph whole(s.free(), [&](int y, std::vector<std::uint32_t>& row) {
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = scene.areas[static_cast<std::size_t>(5 - y)][x] == 'A' ? 0 : 1;
    }
  });
  double farthest = 0;
  ASSERT_EQ(whole.portals().size(), 1U);
  const Portal& portal = whole.portals()[0];
  const auto pieces = test::piecesOf(whole, s.geometry(), portal);
  for (const auto& [place, length] : lengthsAlong(pieces, portal)) {
    farthest = std::max(farthest, length);
  }
  EXPECT_EQ(pieces.size(), 9U);
  EXPECT_GE(portal.reach, farthest);
  EXPECT_FALSE(portal.straight);
}

TEST(CellLookup, AgreeWithTheGridAwayFromItsLines) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Sample s = randomSample(random);
    const MapGeometry& g = s.scene.grid.geometry;
    const CellLookup cells(g, s.map->grid());
    const AGrid& grid = s.map->grid();
    const auto isNearLine = [](const std::vector<double>& lines, double value) {
      return std::any_of(lines.begin(), lines.end(),
                         [&](double line) { return std::abs(line - value) < 1e-9; });
    };
    for (std::size_t i = 0; i < g.pixelCount(); ++i) {
      const Point2 center_grid = inverse(grid.mapFromGrid()) * g.center(g.pixel(i));
      const auto cell = grid.cellAtGridPoint(center_grid);
      if (!cell || isNearLine(grid.x(), center_grid.x()) || isNearLine(grid.y(), center_grid.y())) {
        continue;
      }
      EXPECT_EQ(cellOf(cells, g.pixel(i)), grid.index(*cell)) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace agrid::planning
