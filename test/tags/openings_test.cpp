// SPDX-License-Identifier: BSD-3-Clause
#include "tags/openings.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "support/drawn_plan.h"
#include "support/measured_space.h"
#include "tags/free_space.h"

namespace agrid {
namespace {

using test::DrawnPlan;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

Segment shortened(const Segment& segment, double by) {
  const double length = segment.length();
  const Point2 step = (segment.b - segment.a) / length * std::min(by, 0.3 * length);
  return {segment.a + step, segment.b - step};
}

bool doCross(const Segment& p, const Segment& q) {
  const Point2 u = p.b - p.a;
  const Point2 v = q.b - q.a;
  const double scale = cross(u, v);
  if (std::abs(scale) < 1e-12) return false;
  const double along_p = cross(q.a - p.a, v) / scale;
  const double along_q = cross(q.a - p.a, u) / scale;
  return along_p > 0 && along_p < 1 && along_q > 0 && along_q < 1;
}

/// Whether only one of two openings may stay.
bool exclude(const Segment& p, const Segment& q, double resolution) {
  const double apart = std::min(std::max((p.a - q.a).norm(), (p.b - q.b).norm()),
                                std::max((p.a - q.b).norm(), (p.b - q.a).norm()));
  const double touch = 0.2 / resolution;
  return apart < 0.5 / resolution || doCross(shortened(p, touch), shortened(q, touch));
}

bool isSame(const Opening& p, const Opening& q) {
  return p.jambs.a == q.jambs.a && p.jambs.b == q.jambs.b && p.merit == q.merit;
}

/// What findOpenings promises, seen from all that was found.
void checkChoice(const cv::Mat1b& space, double resolution) {
  const test::MeasuredSpace measured(space, resolution);
  const Sight& sight = measured.sight;
  const auto corners = findWallCorners(space, resolution);
  const WallDirections walls(corners, resolution);
  std::vector<Opening> found = findWallGaps(corners, walls, sight);
  const auto mouths = findMouths(corners, walls, sight);
  found.insert(found.end(), mouths.begin(), mouths.end());
  const auto kept = findOpenings(space, sight);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (i > 0) {
      EXPECT_GE(kept[i - 1].merit, kept[i].merit);
    }
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const Opening& o) { return isSame(o, kept[i]); }));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(exclude(kept[i].jambs, kept[j].jambs, resolution));
    }
  }
  for (const Opening& opening : found) {
    EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](const Opening& better) {
      return isSame(opening, better) ||
             (better.merit >= opening.merit && exclude(opening.jambs, better.jambs, resolution));
    })) << "left out for nothing";
  }
}

TEST(Openings, OfTwoThatExcludeEachOtherTheBetterStays) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    OfficeParams params;
    params.size = 300;
    params.seed = seed;
    const Office office = generateOffice(params);
    checkChoice(cleanFreeSpace(OccupancyMap(office.grid), {}), params.resolution);
  }
  std::mt19937 random(8);
  const auto pick = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
  };
  for (int run = 0; run < 30; ++run) {
    cv::Mat1b space(90, 120, std::uint8_t{0});
    for (int k = 0; k < 12; ++k) {
      space(cv::Rect(pick(0, 80), pick(0, 60), pick(6, 40), pick(6, 30))) = 1;
    }
    checkChoice(space, 0.05);
  }
}

TEST(Openings, ADoorIsOneHoweverManyCornersFindIt) {
  const DrawnPlan plan = DrawnPlan(10, 6)
                             .open({0.5, 0.5}, {4.9, 5.5})
                             .open({5.1, 0.5}, {9.5, 5.5})
                             .open({4.5, 2.5}, {5.5, 3.4});
  const cv::Mat1b space = plan.freeSpace();
  const test::MeasuredSpace measured(space, 0.05);
  const Sight& sight = measured.sight;
  const auto corners = findWallCorners(space, 0.05);
  EXPECT_GE(findWallGaps(corners, WallDirections(corners, 0.05), sight).size(), 2U);
  const auto openings = findOpenings(space, sight);
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_NEAR(openings[0].jambs.length(), 18, 0.5);
}

TEST(Openings, WhereCorridorsCrossTheirOpeningsStayTogether) {
  const DrawnPlan plan =
      DrawnPlan(11, 11).open({0.5, 4.5}, {10.5, 6.5}).open({4.5, 0.5}, {6.5, 10.5});
  const cv::Mat1b space = plan.freeSpace();
  const auto openings = findOpenings(space, test::MeasuredSpace(space, 0.05).sight);
  EXPECT_EQ(openings.size(), 4U) << "they touch at the corners, but do not cross";
  for (const Opening& opening : openings) EXPECT_NEAR(opening.jambs.length(), 40, 1.5);
}

TEST(Openings, TheSameMapHasTheSameOpeningsInTheSameOrder) {
  OfficeParams params;
  params.size = 300;
  params.seed = 5;
  const cv::Mat1b space = cleanFreeSpace(OccupancyMap(generateOffice(params).grid), {});
  const test::MeasuredSpace measured(space, params.resolution);
  const Sight& sight = measured.sight;
  const auto first = findOpenings(space, sight);
  const auto second = findOpenings(space, sight);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GT(first.size(), 3U);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(isSame(first[i], second[i]));
}

TEST(Openings, MapsCoarserThanTwentyCentimetresHaveNone) {
  DrawnPlan plan = DrawnPlan(20, 10).open({1, 1}, {9.8, 9}).open({10.2, 1}, {19, 9});
  plan.open({9, 4}, {11, 6});
  const auto countAt = [&](double resolution) {
    const test::MeasuredSpace measured(plan.at(resolution).freeSpace(), resolution);
    return findOpenings(measured.space, measured.sight).size();
  };
  EXPECT_EQ(countAt(0.2), 1U);
  EXPECT_EQ(countAt(0.25), 0U);
}

TEST(Openings, AMapWithoutFreeSpaceHasNone) {
  const cv::Mat1b space(20, 30, std::uint8_t{0});
  EXPECT_TRUE(findOpenings(space, test::MeasuredSpace(space, 0.05).sight).empty());
}

}  // namespace
}  // namespace agrid
