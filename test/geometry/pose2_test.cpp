// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/geometry/pose2.h"

#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Pose2, TurnsCounterClockwiseThenMoves) {
  const Pose2 a_from_b{{1, 2}, kPi / 2};
  const Point2 point_a = a_from_b * Point2(3, 0);
  EXPECT_NEAR(point_a.x(), 1, 1e-12);
  EXPECT_NEAR(point_a.y(), 5, 1e-12);
}

TEST(Pose2, InverseUndoesAndProductsCompose) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-7, 7);
  for (int i = 0; i < 100; ++i) {
    const Pose2 a_from_b{{value(random), value(random)}, value(random)};
    const Pose2 b_from_c{{value(random), value(random)}, value(random)};
    const Point2 point_c(value(random), value(random));
    EXPECT_LT(((a_from_b * b_from_c) * point_c - a_from_b * (b_from_c * point_c)).norm(), 1e-12);
    EXPECT_LT((inverse(a_from_b) * (a_from_b * point_c) - point_c).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace agrid
