// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/footprint.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "planning/three_rooms.h"

namespace agrid {
namespace {

using planning::Footprint;
using planning::footprintProblem;
using planning::isNearSquare;

const Polygon kForklift{{1.5, 0.4}, {-0.3, 0.4}, {-0.3, -0.4}, {1.5, -0.4}};

struct BadFootprint {
  std::string word;  ///< of the message
  Polygon corners;
};

std::vector<BadFootprint> badFootprints() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {{"2 points", {{1, 0}, {-1, 0}}},
          {"1001 points", Polygon(1001, Point2(1, 1))},
          {"finite", {{1, 0}, {nan, 1}, {-1, -1}}},
          {"finite", {{1, 0}, {std::numeric_limits<double>::infinity(), 1}, {-1, -1}}},
          {"meet", {{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}},           // a bow tie
          {"meet", {{1, 1}, {-1, 1}, {-1, -1}, {-1, 2}, {1, -1}}},  // folded back
          {"meet", {{1, 1}, {1, 1}, {-1, 0}, {1, -1}}},             // a corner twice
          {"meet", {{1, 0}, {0, 0}, {-1, 0}}},                      // no inside
          {"origin", {{1, 1}, {2, 1}, {2, 2}}}};
}

TEST(Footprint, P9_BadOutlinesGetOneClearError) {
  const test::Scene scene = test::threeRooms();
  for (const BadFootprint& bad : badFootprints()) {
    EXPECT_NE(footprintProblem(bad.corners).find(bad.word), std::string::npos)
        << footprintProblem(bad.corners) << ", not " << bad.word;
    PlannerParams params;
    params.footprint = bad.corners;
    try {
      const Planner planner(test::mapOf(scene), params);
      FAIL() << bad.word;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("footprint"), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find(';'), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(footprintProblem(kForklift), "");
  EXPECT_EQ(footprintProblem(Polygon(kForklift.rbegin(), kForklift.rend())), "");
}

TEST(Footprint, HasTheCirclesInsideAndAroundIt) {
  const Footprint forklift(kForklift);
  EXPECT_DOUBLE_EQ(forklift.innerRadius(), 0.3);
  EXPECT_DOUBLE_EQ(forklift.outerRadius(), std::hypot(1.5, 0.4));
}

TEST(Footprint, TouchesASquareFromInsideAndFromOutside) {
  EXPECT_TRUE(isNearSquare({{5, 5}, {-5, 5}, {-5, -5}, {5, -5}}, {1, 1}, 0));
  EXPECT_TRUE(isNearSquare({{0.1, 0.1}, {-0.1, 0.1}, {0, -0.1}}, {0, 0}, 0));
  EXPECT_TRUE(isNearSquare(kForklift, {2, 0.9}, 0));  // at the corner (1.5, 0.4)
  EXPECT_FALSE(isNearSquare(kForklift, {2.001, 0.9}, 0));
  EXPECT_TRUE(isNearSquare(kForklift, {2.1, 0}, 0.11));
  EXPECT_FALSE(isNearSquare(kForklift, {2.1, 0}, 0.09));
  // A square in the notch of an L is near it, but not inside.
  const Polygon l_shape{{-1, -1}, {3, -1}, {3, 1}, {1, 1}, {1, 3}, {-1, 3}};
  EXPECT_FALSE(isNearSquare(l_shape, {2, 2}, 0.4));
  EXPECT_TRUE(isNearSquare(l_shape, {2, 2}, 0.6));
}

}  // namespace
}  // namespace agrid
