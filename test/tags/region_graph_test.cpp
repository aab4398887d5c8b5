// SPDX-License-Identifier: BSD-3-Clause
#include "tags/region_graph.h"

#include <gtest/gtest.h>

#include "support/drawn_plan.h"
#include "support/regions.h"

namespace agrid {
namespace {

using test::DrawnPlan;
using test::Regions;

constexpr double kPixel = 0.05;  // [m]

/// Three rooms in a row, 3 m, 2 m and 4 m wide and 3 m high, with doors of 1 m; from the first two
/// of them, doors of 1 m and 1.3 m lead down into a corridor.
DrawnPlan rooms() {
  return DrawnPlan(11, 6)
      .open({0.5, 2.5}, {3.5, 5.5})
      .open({3.7, 2.5}, {5.7, 5.5})
      .open({5.9, 2.5}, {9.9, 5.5})
      .open({0.5, 0.5}, {9.9, 2.3})
      .open({3.4, 3}, {3.8, 4})
      .open({5.6, 4.3}, {6, 5.3})
      .open({1, 2.2}, {2, 2.6})
      .open({4, 2.2}, {5.3, 2.6});
}

std::uint32_t roomAt(const Point2& p) {
  if (p.y() < 48) return 3;
  return p.x() < 72 ? 0 : p.x() < 116 ? 1 : 2;
}

std::vector<std::uint32_t> neighboursOf(const RegionGraph& graph, std::uint32_t region) {
  std::vector<std::uint32_t> neighbours;
  graph.forEachNeighbour(region, [&](std::uint32_t i) { neighbours.push_back(i); });
  return neighbours;
}

TEST(RegionGraph, ARectanglesShape) {
  const DrawnPlan plan = DrawnPlan(6, 5).open({1, 1}, {5, 4});
  const Regions regions(plan.freeSpace(), kPixel, [](const Point2&) { return 0; });
  const RegionGraph graph = regions.graph();
  ASSERT_EQ(graph.size(), 1U);
  const RegionShape& shape = graph.shape(0);
  EXPECT_NEAR(shape.size, 12, 1e-6);
  EXPECT_NEAR(shape.clearance, 1.5, 1e-6) << "30 pixels from centre to centre";
  EXPECT_NEAR(shape.hull_size, 12, 1e-3);
  EXPECT_NEAR(shape.rectangle_size, 12, 1e-3);
  EXPECT_FALSE(graph.hasNeighbour(0));
}

TEST(RegionGraph, AnLsShape) {
  const DrawnPlan plan = DrawnPlan(6, 5).open({1, 1}, {5, 2}).open({1, 1}, {2, 4});
  const Regions regions(plan.freeSpace(), kPixel, [](const Point2&) { return 0; });
  const RegionGraph graph = regions.graph();
  const RegionShape& shape = graph.shape(0);
  EXPECT_NEAR(shape.size, 4 + 2, 1e-6);
  EXPECT_NEAR(shape.hull_size, 4 * 3 - 3 * 2 / 2., 1e-3);
  EXPECT_NEAR(shape.rectangle_size, 12, 1e-3);
  EXPECT_NEAR(shape.clearance, 0.6, 0.1) << "where both arms meet";
}

TEST(RegionGraph, ATurnedRectanglesShape) {
  const DrawnPlan plan = DrawnPlan(6, 5).open({1, 1}, {5, 4}).at(0.05, 30);
  const Regions regions(plan.freeSpace(), kPixel, [](const Point2&) { return 0; });
  const RegionGraph graph = regions.graph();
  const RegionShape& shape = graph.shape(0);
  EXPECT_NEAR(shape.size, 12, 0.1);
  EXPECT_NEAR(shape.hull_size, 12, 0.5);
  EXPECT_NEAR(shape.rectangle_size, 12, 0.7);
}

TEST(RegionGraph, NeighboursHaveABorder) {
  const Regions regions(rooms().freeSpace(), kPixel, roomAt);
  const RegionGraph graph = regions.graph();
  ASSERT_EQ(graph.size(), 4U);
  EXPECT_EQ(neighboursOf(graph, 0), (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(neighboursOf(graph, 1), (std::vector<std::uint32_t>{0, 2, 3}));
  EXPECT_EQ(neighboursOf(graph, 2), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(neighboursOf(graph, 3), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(graph.profiles().size(), 4U);
}

TEST(RegionGraph, MeasuresOfABorderByHand) {
  const Regions regions(rooms().freeSpace(), kPixel, roomAt);
  const RegionGraph graph = regions.graph();
  const BorderMeasures m = graph.measure(1, 2);
  EXPECT_EQ(m.smaller, &graph.shape(1));
  EXPECT_EQ(m.larger, &graph.shape(2));
  EXPECT_EQ(m.smaller_neighbours, 3U);
  EXPECT_EQ(m.larger_neighbours, 1U);
  EXPECT_NEAR(m.widest->width, 1, kPixel);
  EXPECT_NEAR(m.smaller_side->depth, 2.1, 3 * kPixel);
  EXPECT_NEAR(m.larger_side->depth, 4.1, 3 * kPixel);
  // both rooms, the wall between them and half a door's depth on either side
  EXPECT_NEAR(m.common_rectangle_size, 6.3 * 3.1, 0.7);
  EXPECT_NEAR(m.common_hull_size, 6.2 * 3, 0.8);
}

TEST(RegionGraph, MeasuresDoNotDependOnTheOrder) {
  const Regions regions(rooms().freeSpace(), kPixel, roomAt);
  const RegionGraph graph = regions.graph();
  for (std::uint32_t region = 0; region < 4; ++region) {
    for (const std::uint32_t neighbour : neighboursOf(graph, region)) {
      const BorderMeasures there = graph.measure(region, neighbour);
      const BorderMeasures back = graph.measure(neighbour, region);
      EXPECT_EQ(there.widest, back.widest);
      EXPECT_EQ(there.smaller_side, back.smaller_side);
      EXPECT_EQ(there.larger_side, back.larger_side);
      EXPECT_EQ(there.smaller, back.smaller);
      EXPECT_EQ(there.larger, back.larger);
      EXPECT_EQ(there.smaller_neighbours, back.smaller_neighbours);
      EXPECT_EQ(there.larger_neighbours, back.larger_neighbours);
      EXPECT_EQ(there.common_hull_size, back.common_hull_size);
      EXPECT_EQ(there.common_rectangle_size, back.common_rectangle_size);
    }
  }
}

TEST(RegionGraph, AMergeKeepsTheLargerNumberAndMovesTheBorders) {
  const Regions regions(rooms().freeSpace(), kPixel, roomAt);
  RegionGraph graph = regions.graph();
  const double size = graph.shape(0).size + graph.shape(1).size;
  EXPECT_EQ(graph.merge(1, 0), 0U) << "9 m^2 against 6 m^2";
  EXPECT_NEAR(graph.shape(0).size, size, 1e-9);
  EXPECT_FALSE(graph.hasNeighbour(1));
  EXPECT_EQ(neighboursOf(graph, 0), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(neighboursOf(graph, 2), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(neighboursOf(graph, 3), (std::vector<std::uint32_t>{0}));
  EXPECT_NEAR(graph.measure(0, 3).widest->width, 1.3, kPixel) << "of the doors of both";
  const BorderMeasures right = graph.measure(2, 0);
  EXPECT_EQ(right.smaller, &graph.shape(2)) << "12 m^2 against 15 m^2";
  EXPECT_NEAR(right.smaller_side->depth, 4.1, 3 * kPixel) << "the sides keep theirs";
}

TEST(RegionGraph, MergingAllLeavesOneWithTheShapeOfAll) {
  const cv::Mat1b space = rooms().freeSpace();
  const Regions regions(space, kPixel, roomAt);
  RegionGraph graph = regions.graph();
  const std::uint32_t all = graph.merge(graph.merge(graph.merge(0, 1), 3), 2);
  EXPECT_FALSE(graph.hasNeighbour(all));
  const Regions one(space, kPixel, [](const Point2&) { return 0; });
  const RegionGraph whole = one.graph();
  EXPECT_NEAR(graph.shape(all).size, whole.shape(0).size, 1e-9);
  EXPECT_NEAR(graph.shape(all).hull_size, whole.shape(0).hull_size, 1e-3);
  EXPECT_NEAR(graph.shape(all).rectangle_size, whole.shape(0).rectangle_size, 1e-3);
  EXPECT_NEAR(graph.shape(all).clearance, whole.shape(0).clearance, 1e-9);
}

TEST(RegionGraph, AmongRegionsOfOneSizeTheHigherNumberIsTheLarger) {
  const DrawnPlan plan = DrawnPlan(6, 3).open({1, 1}, {5, 2});
  const Regions regions(plan.freeSpace(), kPixel,
                        [](const Point2& p) { return p.x() < 60 ? 0 : 1; });
  RegionGraph graph = regions.graph();
  EXPECT_EQ(graph.measure(0, 1).larger, &graph.shape(1));
  EXPECT_EQ(graph.merge(0, 1), 1U);
}

}  // namespace
}  // namespace agrid
