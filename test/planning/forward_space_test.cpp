// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/forward_space.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

namespace agrid {
namespace {

namespace ob = ompl::base;
using planning::ForwardSpace;

constexpr double kRadius = 0.5;

class Forward : public testing::Test {
 protected:
  Forward() {
    ob::RealVectorBounds bounds(2);
    bounds.setLow(-9);
    bounds.setHigh(9);
    for (const auto& space : {ours_->as<ob::SE2StateSpace>(), ompl_->as<ob::SE2StateSpace>()}) {
      space->setBounds(bounds);
      space->setup();
    }
  }
  ob::ScopedState<ob::SE2StateSpace> state(double x, double y, double yaw) const {
    ob::ScopedState<ob::SE2StateSpace> result(ours_);
    result->setXY(x, y);
    result->setYaw(yaw);
    return result;
  }
  ob::ScopedState<ob::SE2StateSpace> random(double reach) {
    std::uniform_real_distribution<double> place(-reach, reach);
    std::uniform_real_distribution<double> yaw(-3.1415, 3.1415);
    return state(place(random_), place(random_), yaw(random_));
  }

  ob::StateSpacePtr ours_ = std::make_shared<ForwardSpace>(kRadius);
  ob::StateSpacePtr ompl_ = std::make_shared<ob::DubinsStateSpace>(kRadius);
  std::mt19937 random_{5};
};

TEST_F(Forward, IsAsShortAsTheCurvesOfOmpl) {
  for (int i = 0; i < 20000; ++i) {
    const auto a = random(i % 2 == 0 ? 0.5 : 4);
    const auto b = random(i % 2 == 0 ? 0.5 : 4);
    EXPECT_NEAR(ours_->distance(a.get(), b.get()), ompl_->distance(a.get(), b.get()), 1e-6);
  }
}

TEST_F(Forward, InterpolatesWithTheCurvatureAllowedAndForwards) {
  for (int i = 0; i < 300; ++i) {
    const auto a = random(1.5);
    const auto b = random(1.5);
    const double length = ours_->distance(a.get(), b.get());
    const int steps = 200;
    auto last = a;
    for (int k = 1; k <= steps; ++k) {
      auto next = a;
      ours_->interpolate(a.get(), b.get(), static_cast<double>(k) / steps, next.get());
      const Eigen::Vector2d way(next->getX() - last->getX(), next->getY() - last->getY());
      const double turned = std::remainder(next->getYaw() - last->getYaw(), 2 * M_PI);
      EXPECT_LE(std::abs(turned), length / steps / kRadius + 1e-6);
      EXPECT_LE(way.norm(), length / steps + 1e-6);
      EXPECT_GT(way.dot(Eigen::Vector2d(std::cos(last->getYaw()), std::sin(last->getYaw()))), 0);
      last = next;
    }
    EXPECT_NEAR(ours_->distance(last.get(), b.get()), 0, 1e-5);
  }
}

// Poses at which parts of a curve vanish; OMPL's own space ends the process near such ones.
TEST_F(Forward, AnswersWherePartsOfACurveVanish) {
  for (int i = 0; i < 20000; ++i) {
    const auto a = random(2);
    const double step = std::pow(10, -(i % 12));
    const double yaw = a->getYaw();
    const auto ahead =
        state(a->getX() + step * std::cos(yaw), a->getY() + step * std::sin(yaw), yaw);
    EXPECT_NEAR(ours_->distance(a.get(), ahead.get()), step, 1e-6);
    const double turn = 1e-3 + (i % 7) * 0.4;
    const auto on_arc = state(a->getX() + kRadius * (std::sin(yaw + turn) - std::sin(yaw)),
                              a->getY() + kRadius * (std::cos(yaw) - std::cos(yaw + turn)),
                              std::remainder(yaw + turn, 2 * M_PI));
    EXPECT_NEAR(ours_->distance(a.get(), on_arc.get()), kRadius * turn, 1e-5);
  }
}

}  // namespace
}  // namespace agrid
