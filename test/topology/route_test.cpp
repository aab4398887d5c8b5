// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/topology/route.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace agrid {
namespace {

AreaMap randomAreas(std::mt19937& random, int area_count, int door_count) {
  std::uniform_real_distribution<double> place(0, 10);
  std::uniform_int_distribution<std::uint32_t> side(1, static_cast<std::uint32_t>(area_count));
  AreaMap map;
  for (int i = 1; i <= area_count; ++i) {
    Area area;
    area.id = AreaId{static_cast<std::uint32_t>(i)};
    area.anchor_map = {place(random), place(random)};
    map.areas.push_back(area);
  }
  for (int i = 0; i < door_count; ++i) {
    Door door;
    door.areas = {AreaId{side(random)}, AreaId{side(random)}};
    if (door.areas[0] == door.areas[1]) continue;
    const Point2 middle(place(random), place(random));
    door.jambs_map = {middle - Point2(0.4, 0), middle + Point2(0.4, 0)};
    map.doors.push_back(door);
  }
  return map;
}

/// Every route that enters no area twice, by trying all of them.
struct AllRoutes {
  const AreaMap& map;
  const TopologicalGraph& graph;
  const RouteQuery& query;
  std::vector<Route> routes = {};

  void extend(Route route, const Point2& here) {
    const std::size_t area = route.areas.back();
    if (area == query.goal_area) {
      route.length += (query.goal_map - here).norm();
      routes.push_back(route);
      return;
    }
    for (const Passage& p : graph.passages[area]) {
      if (std::count(route.areas.begin(), route.areas.end(), p.area) > 0) continue;
      if (query.usable && !query.usable(p.door)) continue;
      const Point2 there = map.doors[p.door].jambs_map.midpoint();
      Route next = route;
      next.areas.push_back(p.area);
      next.doors.push_back(p.door);
      next.length += (there - here).norm();
      extend(next, there);
    }
  }
  std::vector<Route> sorted() {
    extend({{query.start_area}, {}, 0}, query.start_map);
    std::sort(routes.begin(), routes.end(),
              [](const Route& a, const Route& b) { return a.length < b.length; });
    return routes;
  }
};

std::vector<Point2> doorPositions(const AreaMap& map) {
  std::vector<Point2> positions;
  for (const Door& door : map.doors) positions.push_back(door.jambs_map.midpoint());
  return positions;
}

TEST(FindRoutes, AreTheShortestOfAllRoutesInOrder) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const AreaMap map = randomAreas(random, 6, 9);
    const TopologicalGraph graph = buildGraph(map);
    const auto closed = static_cast<std::size_t>(trial % 5);
    const RouteQuery query{0, 5, map.areas[0].anchor_map, map.areas[5].anchor_map,
                           [&](std::size_t door) { return door != closed; }};
    const auto all = AllRoutes{map, graph, query}.sorted();
    const auto found = findRoutes(graph, doorPositions(map), query, 4);
    ASSERT_EQ(found.size(), std::min<std::size_t>(4, all.size())) << "trial " << trial;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].length, all[i].length, 1e-9) << "trial " << trial << " route " << i;
      EXPECT_EQ(found[i].areas.size(), found[i].doors.size() + 1);
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(found[i].doors, found[j].doors);
    }
  }
}

TEST(FindRoute, LeadsFromAnchorToAnchorThroughTheNearestDoor) {
  AreaMap map;
  for (std::uint32_t i = 1; i <= 2; ++i) {
    Area area;
    area.id = AreaId{i};
    area.anchor_map = {i == 1 ? 0.0 : 4.0, 0.0};
    map.areas.push_back(area);
  }
  for (const double y : {3.0, 0.0}) {
    Door door;
    door.areas = {AreaId{1}, AreaId{2}};
    door.jambs_map = {{2, y - 0.5}, {2, y + 0.5}};
    map.doors.push_back(door);
  }
  const TopologicalGraph graph = buildGraph(map);
  const auto direct = findRoute(map, graph, 0, 1, {});
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->doors, std::vector<std::size_t>{1});
  EXPECT_DOUBLE_EQ(direct->length, 4);
  const auto round = findRoute(map, graph, 0, 1, [](std::size_t door) { return door == 0; });
  ASSERT_TRUE(round);
  EXPECT_EQ(round->doors, std::vector<std::size_t>{0});
  EXPECT_FALSE(findRoute(map, graph, 0, 1, [](std::size_t) { return false; }));
}

TEST(FindRoute, StaysWhereItIs) {
  AreaMap map;
  map.areas.resize(1);
  const auto route = findRoute(map, buildGraph(map), 0, 0, {});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->areas, std::vector<std::size_t>{0});
  EXPECT_TRUE(route->doors.empty());
}

TEST(FindRoute, RefusesAreasThatDoNotExist) {
  AreaMap map;
  map.areas.resize(1);
  EXPECT_THROW(findRoute(map, buildGraph(map), 0, 1, {}), std::invalid_argument);
}

}  // namespace
}  // namespace agrid
