// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/costmap_areas.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// 40 x 30 pixels of 0.1 m, lower left corner at (1, 2), every pixel free.
Costmap freeMap() {
  Costmap map;
  map.geometry = {40, 30, 0.1, {{1, 2}, 0}};
  map.costs.assign(map.geometry.pixelCount(), 0);
  return map;
}

AreaCost box(double x0, double y0, double x1, double y1, double factor) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, (x1 - x0) * (y1 - y0), factor};
}

std::uint8_t costAt(const Costmap& map, double x, double y) {
  return map.costs[map.geometry.index(map.geometry.pixelAt({x, y}).value())];
}

Costmap raised(const AreaCosts& areas, Costmap map = freeMap(), const CostRules& rules = {}) {
  CostmapAreas(areas, map.geometry, rules).raise(map);
  return map;
}

TEST(CostmapAreas, AMetreCountsItsFactorByTheRulesOfTheGlobalPlanner) {
  const Costmap map = raised({{box(2, 2.5, 3, 3.5, 4), box(3, 2.5, 4, 3.5, 0.5)}, {}});
  EXPECT_EQ(costAt(map, 2.5, 3), 50);  // 50 + 3 * 50 = 4 * 50
  EXPECT_EQ(costAt(map, 3.5, 3), 0);   // nothing counts less than a free pixel
  EXPECT_EQ(costAt(map, 1.5, 3), 0);
  CostRules rules;
  rules.neutral_cost = 10;
  rules.cost_factor = 1;
  EXPECT_EQ(costAt(raised({{box(2, 2.5, 3, 3.5, 4)}, {}}, freeMap(), rules), 2.5, 3), 30);
}

TEST(CostmapAreas, ForbiddenIsLethalAndADearAreaNeverIs) {
  const Costmap map = raised({{box(2, 2.5, 3, 3.5, kForbidden), box(3, 2.5, 4, 3.5, 1000)}, {}});
  EXPECT_EQ(costAt(map, 2.5, 3), kLethal);
  EXPECT_EQ(costAt(map, 3.5, 3), CostmapAreas::kDearest);
}

TEST(CostmapAreas, NothingBecomesCheaperAndUnknownStaysUnknownUnlessItIsForbidden) {
  Costmap map = freeMap();
  const auto set = [&](double x, std::uint8_t cost) {
    map.costs[map.geometry.index(map.geometry.pixelAt({x, 3.05}).value())] = cost;
  };
  for (const double x : {2.05, 3.05}) set(x, kNoInformation);
  for (const double x : {2.15, 3.15}) set(x, 100);
  for (const double x : {2.25, 3.25}) set(x, kLethal);
  map = raised({{box(2, 2.5, 3, 3.5, 4), box(3, 2.5, 4, 3.5, kForbidden)}, {}}, map);
  EXPECT_EQ(costAt(map, 2.05, 3.05), kNoInformation);
  EXPECT_EQ(costAt(map, 2.15, 3.05), 100);
  EXPECT_EQ(costAt(map, 2.25, 3.05), kLethal);
  EXPECT_EQ(costAt(map, 2.35, 3.05), 50);
  for (const double x : {3.05, 3.15, 3.25}) EXPECT_EQ(costAt(map, x, 3.05), kLethal);
}

TEST(CostmapAreas, OfAreasInOneAnotherTheSmallerOneCounts) {
  const AreaCost hall = box(1.5, 2.2, 4.5, 4.8, 4);
  const AreaCost kiosk = box(2.5, 3, 3.5, 4, 1);
  for (const auto& areas : {std::vector<AreaCost>{hall, kiosk}, {kiosk, hall}}) {
    const Costmap map = raised({areas, {}});
    EXPECT_EQ(costAt(map, 3, 3.5), 0);
    EXPECT_EQ(costAt(map, 2, 3.5), 50);
  }
}

TEST(CostmapAreas, AClosedDoorIsLethalFromWallToWall) {
  Costmap map = freeMap();
  for (int y = 0; y < 30; ++y) {
    if (y < 10 || y >= 20) map.costs[map.geometry.index({15, y})] = kLethal;
  }
  // jambs that end 2 pixels short of the walls
  map = raised({{}, {{{2.55, 3.25}, {2.55, 3.75}}}}, map);
  for (int y = 0; y < 30; ++y) EXPECT_EQ(map.costs[map.geometry.index({15, y})], kLethal) << y;
  for (int y = 0; y < 30; ++y) EXPECT_EQ(map.costs[map.geometry.index({17, y})], 0) << y;
}

TEST(CostmapAreas, OnlyTheWindowIsTouched) {
  const Costmap all = raised({{box(1, 2, 5, 5, kForbidden)}, {{{1, 2}, {5, 5}}}});
  Costmap map = freeMap();
  const CostmapAreas areas({{box(1, 2, 5, 5, kForbidden)}, {{{1, 2}, {5, 5}}}}, map.geometry, {});
  areas.raise(map.costs.data(), {10, 5}, {20, 15});
  for (std::size_t i = 0; i < map.costs.size(); ++i) {
    const Pixel p = map.geometry.pixel(i);
    const bool inside = p.x >= 10 && p.x < 20 && p.y >= 5 && p.y < 15;
    EXPECT_EQ(map.costs[i], inside ? all.costs[i] : 0) << p.x << " " << p.y;
  }
}

TEST(CostmapAreas, ARobotInAForbiddenAreaOrAClosedDoorCanLeave) {
  const AreaCosts areas{{box(2, 2.5, 3, 3.5, kForbidden), box(3, 2.5, 4, 3.5, kForbidden)},
                        {{{2, 4}, {2, 4.8}}, {{4, 4}, {4, 4.8}}}};
  EXPECT_EQ(leavable(areas, {1.2, 2.2}, 0.2), areas);
  const Costmap inside = raised(leavable(areas, {2.5, 3}, 0.2));
  EXPECT_EQ(costAt(inside, 2.5, 3), CostmapAreas::kDearest);
  EXPECT_EQ(costAt(inside, 3.5, 3), kLethal);
  const AreaCosts in_door = leavable(areas, {2.15, 4.4}, 0.2);
  ASSERT_EQ(in_door.closed_doors.size(), 1U);
  EXPECT_EQ(in_door.closed_doors[0].a, Point2(4, 4));
}

TEST(CostmapAreas, OutlinesAndDoorsBeyondTheMapOrNotFiniteDoNoHarm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Costmap map = raised({{box(-1e6, -1e6, 1e6, 1e6, 4),
                               box(90, 90, 91, 91, kForbidden),
                               {{{nan, 3}, {2, nan}, {3, 3}}, 1, kForbidden},
                               {{}, 0, kForbidden}},
                              {{{nan, 3}, {2, 3}}, {{90, 90}, {91, 91}}}});
  for (const std::uint8_t cost : map.costs) EXPECT_EQ(cost, 50);
}

TEST(CostmapAreas, AreMadeAnewWhereTagsOrTheCostmapChange) {
  CurrentAreas current{CostRules{}};
  const AreaCosts forbidden{{box(2, 2.5, 3, 3.5, kForbidden)}, {}};
  Costmap map = freeMap();
  const CostmapAreas* first = &current.get(forbidden, map.geometry);
  first->raise(map);
  EXPECT_EQ(costAt(map, 2.5, 3), kLethal);
  map = freeMap();
  current.get({{box(2, 2.5, 3, 3.5, 1)}, {{{2.55, 3.25}, {2.55, 3.75}}}}, map.geometry).raise(map);
  EXPECT_EQ(costAt(map, 2.5, 2.7), 0);
  EXPECT_EQ(costAt(map, 2.55, 3.5), kLethal);
  map = freeMap();
  map.geometry.map_from_image.position = {2, 2};  // a window that has moved
  current.get(forbidden, map.geometry).raise(map);
  EXPECT_EQ(costAt(map, 2.5, 3), kLethal);
  EXPECT_EQ(costAt(map, 3.5, 3), 0);
}

TEST(CostmapAreas, RandomOutlinesHoldThePixelsWhoseCentresTurnAroundThem) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.5, 5.5), y(1.5, 5.5);
  for (int trial = 0; trial < 200; ++trial) {
    Polygon outline;
    for (int i = 0; i < 3 + trial % 6; ++i) outline.emplace_back(x(random), y(random));
    const Costmap map = raised({{{outline, 1, kForbidden}}, {}});
    for (std::size_t i = 0; i < map.costs.size(); ++i) {
      const Point2 at = map.geometry.center(map.geometry.pixel(i));
      double turns = 0;  // winding number by angles; odd for even-odd's inside of simple outlines
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point2 a = outline[k] - at;
        const Point2 b = outline[(k + 1) % outline.size()] - at;
        turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      }
      const bool inside = std::lround(turns / (2 * M_PI)) % 2 != 0;
      ASSERT_EQ(map.costs[i] == kLethal, inside) << trial << ": " << at.transpose();
    }
  }
}

}  // namespace
}  // namespace agrid
