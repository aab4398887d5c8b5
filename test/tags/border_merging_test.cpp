// SPDX-License-Identifier: BSD-3-Clause
#include "tags/border_merging.h"

#include <set>

#include <gtest/gtest.h>

#include "support/drawn_plan.h"
#include "support/regions.h"

namespace agrid {
namespace {

using test::DrawnPlan;
using test::Regions;

constexpr double kPixel = 0.05;  // [m]

Opening opening(const Point2& a, const Point2& b) {
  Opening result;
  result.jambs = {a, b};
  return result;
}

/// A corridor of 14.5 m x 2 m and above it three rooms of 4.5 m x 4 m, each with a door of 0.9 m.
DrawnPlan rooms() {
  DrawnPlan plan(15.5, 7.7);
  plan.open({0.5, 0.5}, {15, 2.5});
  for (const double x : {0.5, 5.5, 10.5}) {
    plan.open({x, 2.7}, {x + 4.5, 6.7}).open({x + 1.8, 2.4}, {x + 2.7, 2.8});
  }
  return plan;
}

/// The corridor in five pieces, 0 to 4, the rooms 5 to 7.
int pieceAt(const Point2& p) {
  const double x = p.x() * kPixel;
  if (p.y() < 52) return x < 3 ? 0 : x < 6 ? 1 : x < 9 ? 2 : x < 12 ? 3 : 4;
  return x < 5.25 ? 5 : x < 10.25 ? 6 : 7;
}

std::vector<Opening> doors() {
  std::vector<Opening> result;
  for (const double x : {0.5, 5.5, 10.5}) {
    result.push_back(opening({(x + 1.8) / kPixel, 52}, {(x + 2.7) / kPixel, 52}));
  }
  return result;
}

TEST(BorderMerging, APieceOfACorridorIsNoAreaAndARoomWithADoorIs) {
  const Regions regions(rooms().freeSpace(), kPixel, pieceAt, doors());
  const auto region_of = mergeByBorders(regions.graph(), {});
  ASSERT_EQ(region_of.size(), 8U);
  for (std::size_t piece = 1; piece < 5; ++piece) EXPECT_EQ(region_of[piece], region_of[0]);
  EXPECT_EQ(std::set<std::uint32_t>(region_of.begin(), region_of.end()).size(), 4U);
  for (std::size_t room = 5; room < 8; ++room) EXPECT_EQ(region_of[room], room);
  EXPECT_EQ(region_of[region_of[0]], region_of[0]) << "named by one of its own";
}

TEST(BorderMerging, TheThresholdTurnsAllIntoOneOrNoneAway) {
  const Regions regions(rooms().freeSpace(), kPixel, pieceAt, doors());
  AreaParams params;
  params.min_separation = 1;
  const auto one = mergeByBorders(regions.graph(), params);
  EXPECT_EQ(std::set<std::uint32_t>(one.begin(), one.end()).size(), 1U);
  params.min_separation = 0;
  params.min_area_size = 0;
  params.min_area_clearance = 0;
  const auto all = mergeByBorders(regions.graph(), params);
  EXPECT_EQ(std::set<std::uint32_t>(all.begin(), all.end()).size(), 8U);
}

/// A room of 5 m x 5 m and a closet of 0.9 m x 0.9 m that a door of 0.6 m leads to.
DrawnPlan roomWithCloset() {
  return DrawnPlan(8, 6)
      .open({0.5, 0.5}, {5.5, 5.5})
      .open({5.7, 2}, {6.6, 2.9})
      .open({5.4, 2.1}, {5.8, 2.7});
}

TEST(BorderMerging, ASmallAreaJoinsANeighbour) {
  const Regions regions(roomWithCloset().freeSpace(), kPixel,
                        [](const Point2& p) { return p.x() < 112 ? 0 : 1; },
                        {opening({112, 42}, {112, 54})});
  AreaParams params;
  params.min_separation = 0;
  params.min_area_size = 0.5;
  EXPECT_EQ(mergeByBorders(regions.graph(), params), (std::vector<std::uint32_t>{0, 1}));
  params.min_area_size = 1;
  EXPECT_EQ(mergeByBorders(regions.graph(), params), (std::vector<std::uint32_t>{0, 0}));
  params.min_area_size = 0.5;
  params.min_area_clearance = 0.6;
  EXPECT_EQ(mergeByBorders(regions.graph(), params), (std::vector<std::uint32_t>{0, 0}));
}

TEST(BorderMerging, ASmallAreaJoinsTheNeighbourItIsLeastPartedFrom) {
  // a niche of 0.8 m^2 that is open to the room on its left over its whole width, by a door to the
  // other
  const DrawnPlan plan = DrawnPlan(13, 6)
                             .open({0.5, 0.5}, {5.5, 5.5})
                             .open({5.5, 2}, {6.2, 3.2})
                             .open({6.2, 2.3}, {6.4, 2.9})
                             .open({6.4, 0.5}, {12, 5.5});
  const auto regionAt = [](const Point2& p) {
    if (p.x() < 110) return 2;
    return p.x() < 126 ? 1 : 0;
  };
  const Regions regions(plan.freeSpace(), kPixel, regionAt, {opening({126, 46}, {126, 58})});
  AreaParams params;
  params.min_separation = 0;
  EXPECT_EQ(mergeByBorders(regions.graph(), params), (std::vector<std::uint32_t>{0, 2, 2}));
}

TEST(BorderMerging, WithoutANeighbourASmallAreaStays) {
  const DrawnPlan plan = DrawnPlan(3, 2).open({0.5, 0.5}, {1, 1}).open({1.5, 0.5}, {2, 1});
  const Regions regions(plan.freeSpace(), kPixel,
                        [](const Point2& p) { return p.x() < 25 ? 0 : 1; });
  EXPECT_EQ(mergeByBorders(regions.graph(), {}), (std::vector<std::uint32_t>{0, 1}));
}

TEST(BorderMerging, TheSameRegionsMergeTheSameWay) {
  const Regions regions(rooms().freeSpace(), kPixel, pieceAt, doors());
  for (const double min_separation : {0.1, 0.5, 0.9}) {
    AreaParams params;
    params.min_separation = min_separation;
    EXPECT_EQ(mergeByBorders(regions.graph(), params), mergeByBorders(regions.graph(), params));
  }
}

}  // namespace
}  // namespace agrid
