// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/topology/topological_graph.h"

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/segmentation.h"

namespace agrid {
namespace {

AreaMap areasWithIds(const std::vector<std::uint32_t>& ids) {
  AreaMap areas;
  for (const std::uint32_t id : ids) {
    areas.areas.emplace_back();
    areas.areas.back().id = AreaId{id};
  }
  return areas;
}

void addDoor(AreaMap& areas, std::uint32_t a, std::uint32_t b) {
  areas.doors.emplace_back();
  areas.doors.back().id = DoorId{static_cast<std::uint32_t>(areas.doors.size())};
  areas.doors.back().areas = {AreaId{a}, AreaId{b}};
}

void expectPassages(const TopologicalGraph& graph, std::size_t area,
                    const std::vector<std::pair<std::size_t, std::size_t>>& doors_and_areas) {
  ASSERT_EQ(graph.passages[area].size(), doors_and_areas.size()) << "area " << area;
  for (std::size_t i = 0; i < doors_and_areas.size(); ++i) {
    EXPECT_EQ(graph.passages[area][i].door, doors_and_areas[i].first) << "area " << area;
    EXPECT_EQ(graph.passages[area][i].area, doors_and_areas[i].second) << "area " << area;
  }
}

//   10 ---0--- 20 ===1,2=== 40     doors 1 and 2 join the same areas
//    |
//    3                       30 (no door)
//    |
//  outside
TEST(TopologicalGraph, HasAPassageForEachSideOfADoor) {
  AreaMap areas = areasWithIds({10, 20, 30, 40});
  addDoor(areas, 10, 20);
  addDoor(areas, 20, 40);
  addDoor(areas, 40, 20);
  addDoor(areas, 0, 10);
  const TopologicalGraph graph = buildGraph(areas);
  ASSERT_EQ(graph.passages.size(), 4U);
  expectPassages(graph, 0, {{0, 1}});
  expectPassages(graph, 1, {{0, 0}, {1, 3}, {2, 3}});
  expectPassages(graph, 2, {});
  expectPassages(graph, 3, {{1, 1}, {2, 1}});
}

TEST(TopologicalGraph, PassesOverDoorsOfAreasThatAreNotThere) {
  AreaMap areas = areasWithIds({1, 2});
  addDoor(areas, 1, 7);
  expectPassages(buildGraph(areas), 0, {});
}

TEST(TopologicalGraph, OfNothingIsEmpty) { EXPECT_TRUE(buildGraph({}).passages.empty()); }

//   1 --- 2 --- 3     three rooms in a row
TEST(TopologicalGraph, OfThreeRoomsInARowIsAChain) {
  const OccupancyMap map = test::asciiMap(
      {
          "#########################",
          "#.......#.......#.......#",
          "#.......#.......#.......#",
          "#.......................#",
          "#.......................#",
          "#.......#.......#.......#",
          "#.......#.......#.......#",
          "#.......#.......#.......#",
          "#########################",
      },
      0.5);
  const TopologicalGraph graph = buildGraph(test::segment(map));
  ASSERT_EQ(graph.passages.size(), 3U);
  expectPassages(graph, 0, {{0, 1}});
  expectPassages(graph, 1, {{0, 0}, {1, 2}});
  expectPassages(graph, 2, {{1, 1}});
}

//   10 (1 m^2) --0-- 20 (5 m^2)   30 (4 m^2) --1-- 40 (4 m^2)   50 (3 m^2) --2, closed-- 40
TEST(TopologicalGraph, UnreachableIsWhatNoOpenDoorJoinsToTheLargestPart) {
  AreaMap areas = areasWithIds({10, 20, 30, 40, 50});
  const double sizes[]{1, 5, 4, 4, 3};
  for (std::size_t i = 0; i < 5; ++i) areas.areas[i].size = sizes[i];
  addDoor(areas, 10, 20);
  addDoor(areas, 30, 40);
  addDoor(areas, 50, 40);
  areas.doors[2].state = DoorState::kClosed;
  const auto apart = [&areas] { return unreachableAreas(areas, buildGraph(areas)); };
  EXPECT_EQ(apart(), (std::vector<std::size_t>{0, 1, 4}));
  areas.doors[2].state = DoorState::kOpen;
  EXPECT_EQ(apart(), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(unreachableAreas({}, {}).empty());
}

}  // namespace
}  // namespace agrid
