// SPDX-License-Identifier: BSD-3-Clause
#include "tags/separation.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "agrid/evaluation/office_generator.h"
#include "support/drawn_plan.h"
#include "support/measured_space.h"
#include "support/regions.h"
#include "tags/fragments.h"

namespace agrid {
namespace {

using test::DrawnPlan;
using test::Regions;

/// Two rooms of 4 m x 4 m and a door of 0.9 m.
DrawnPlan roomsWithDoor() {
  return DrawnPlan(9.2, 5)
      .open({0.5, 0.5}, {4.5, 4.5})
      .open({4.7, 0.5}, {8.7, 4.5})
      .open({4.4, 2}, {4.8, 2.9});
}

DrawnPlan corridor() { return DrawnPlan(13, 3).open({0.5, 0.5}, {12.5, 2.5}); }

/// Two rooms of 5 m x 4 m with half of the wall between them.
DrawnPlan roomsWithWideOpening() {
  return DrawnPlan(11.2, 5)
      .open({0.5, 0.5}, {5.5, 4.5})
      .open({5.7, 0.5}, {10.7, 4.5})
      .open({5.4, 2.5}, {5.8, 4.5});
}

/// Of the plan cut in two at x [m], which is an opening if there is one.
double separationAt(const DrawnPlan& plan, double x) {
  const double cut = std::round(plan.inImage({x, 0}).x());
  const cv::Mat1b space = plan.freeSpace();
  std::vector<Opening> openings;
  for (const Opening& opening :
       findOpenings(space, test::MeasuredSpace(space, plan.resolution()).sight)) {
    if (std::abs(opening.jambs.midpoint().x() - cut) > 0.3 / plan.resolution()) continue;
    openings.push_back(opening);
    openings.back().jambs.a.x() = openings.back().jambs.b.x() = cut;
  }
  const Regions regions(
      space, plan.resolution(), [&](const Point2& p) { return p.x() < cut ? 0 : 1; }, openings);
  EXPECT_EQ(regions.count, 2U);
  return separation(regions.graph().measure(0, 1));
}

TEST(Separation, ADoorPartsTwoRooms) { EXPECT_GT(separationAt(roomsWithDoor(), 4.6), 0.9); }

TEST(Separation, NothingPartsAnEvenCorridor) {
  for (const double x : {2., 4., 6.5, 11.}) EXPECT_LT(separationAt(corridor(), x), 0.2) << x;
}

TEST(Separation, TheWiderTheOpeningTheLessItParts) {
  double before = 1;
  for (const double width : {0.9, 1.8, 2.7, 3.6}) {
    const DrawnPlan plan = DrawnPlan(9.2, 5)
                               .open({0.5, 0.5}, {4.5, 4.5})
                               .open({4.7, 0.5}, {8.7, 4.5})
                               .open({4.4, 2.5 - width / 2}, {4.8, 2.5 + width / 2});
    const double value = separationAt(plan, 4.6);
    EXPECT_LT(value, before) << width;
    before = value;
  }
}

TEST(Separation, TheResolutionMattersLittle) {
  for (const auto& [plan, x] : {std::pair(roomsWithDoor(), 4.6), std::pair(corridor(), 6.5),
                                std::pair(roomsWithWideOpening(), 5.6)}) {
    DrawnPlan drawn = plan;
    const double expected = separationAt(drawn.at(0.05), x);
    for (const double resolution : {0.025, 0.1}) {
      EXPECT_NEAR(separationAt(drawn.at(resolution), x), expected, 0.15)
          << x << " at " << resolution;
    }
  }
}

TEST(Separation, AQuarterTurnChangesNothing) {
  const cv::Mat1b space = roomsWithDoor().freeSpace();
  cv::Mat1b turned;
  cv::rotate(space, turned, cv::ROTATE_90_CLOCKWISE);
  Opening opening;
  opening.jambs = {{92, 40}, {92, 58}};
  const Regions before(space, 0.05, [](const Point2& p) { return p.x() < 92 ? 0 : 1; }, {opening});
  // column c becomes row c, row r becomes column rows - 1 - r
  const double right = space.rows;
  opening.jambs = {{right - 40, 92}, {right - 58, 92}};
  const Regions after(turned, 0.05, [](const Point2& p) { return p.y() < 92 ? 0 : 1; }, {opening});
  const double expected = separation(before.graph().measure(0, 1));
  EXPECT_NEAR(separation(after.graph().measure(0, 1)), expected, 0.01);
}

TEST(Separation, LiesBetweenZeroAndOneOnAnyMap) {
  std::vector<cv::Mat1b> spaces;
  OfficeParams params;
  params.size = 400;
  spaces.push_back(cleanFreeSpace(OccupancyMap(generateOffice(params).grid), {}));
  std::mt19937 random(6);
  for (const unsigned density : {3U, 30U, 300U}) {
    cv::Mat1b noise(60, 80);
    for (std::uint8_t& pixel : noise) pixel = random() % density == 0 ? 0 : 1;
    spaces.push_back(noise);
  }
  for (const cv::Mat1b& space : spaces) {
    Relief relief;
    relief.free_space = space;
    relief.height = distanceFromWalls(space);
    const Fragments fragments = cutIntoFragments(relief, 0.05);
    const MapGeometry geometry{space.cols, space.rows, 0.05, {}};
    const auto& labels = fragments.basins.of_pixel;
    const auto stretches = splitIntoStretches(findBorderPoints(labels, geometry), geometry);
    const RegionGraph graph(labels, fragments.basins.basins.size(), stretches,
                            BorderSurvey(relief, fragments.openings, geometry));
    for (std::uint32_t region = 0; region < graph.size(); ++region) {
      graph.forEachNeighbour(region, [&](std::uint32_t neighbour) {
        const double value = separation(graph.measure(region, neighbour));
        EXPECT_GT(value, 0);
        EXPECT_LT(value, 1);
        EXPECT_EQ(value, separation(graph.measure(neighbour, region)));
      });
    }
  }
}

TEST(Separation, StaysFiniteForRegionsOfOnePixel) {
  cv::Mat1b space(3, 4, std::uint8_t{0});
  space(1, 1) = space(1, 2) = 1;
  const Regions regions(space, 0.05, [](const Point2& p) { return p.x() < 2 ? 0 : 1; });
  const double value = separation(regions.graph().measure(0, 1));
  EXPECT_GT(value, 0);
  EXPECT_LT(value, 1);
}

}  // namespace
}  // namespace agrid
