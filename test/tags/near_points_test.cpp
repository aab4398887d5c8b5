// SPDX-License-Identifier: BSD-3-Clause
#include "tags/near_points.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

TEST(NearPoints, AllWithinReachAreVisitedOnceAndNoneFarAway) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-50, 50);
  const double reach = 7;
  NearPoints near(reach);
  std::vector<Point2> points;
  for (std::size_t i = 0; i < 300; ++i) {
    points.emplace_back(coordinate(random), coordinate(random));
    near.add(points.back(), i);
  }
  for (int k = 0; k < 100; ++k) {
    const Point2 place(coordinate(random), coordinate(random));
    std::vector<std::size_t> visited;
    near.forEachNear(place, [&](std::size_t i) { visited.push_back(i); });
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = (points[i] - place).norm();
      const auto visits = std::count(visited.begin(), visited.end(), i);
      if (distance <= reach) {
        EXPECT_EQ(visits, 1) << distance;
      }
      if (distance > 2 * std::sqrt(2.) * reach) {
        EXPECT_EQ(visits, 0) << distance;
      }
      EXPECT_LE(visits, 1);
    }
  }
}

TEST(NearPoints, ThoseOfOneSquareComeInTheOrderTheyWereAddedIn) {
  NearPoints near(10);
  for (const std::size_t i : {5U, 2U, 9U, 2U}) near.add({-3, -4}, i);
  std::vector<std::size_t> visited;
  near.forEachNear({1, 1}, [&](std::size_t i) { visited.push_back(i); });
  EXPECT_EQ(visited, (std::vector<std::size_t>{5, 2, 9, 2}));
}

}  // namespace
}  // namespace agrid
