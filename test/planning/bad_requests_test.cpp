// SPDX-License-Identifier: BSD-3-Clause
// Requests that end early, by the clock or by another thread, whoever plans.
#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using test::Scene;

/// Far beyond what any machine needs, and far below the timeouts it is compared with.
constexpr std::chrono::seconds kGenerous{20};

/// A meander of walls through a map of 16 m: a long way, hard to find for planners that sample.
Scene meander() {
  Scene scene;
  scene.grid.geometry = {320, 320, 0.05, {}};
  scene.grid.values.assign(320 * 320, 0);
  for (int x = 20; x < 320; x += 20) {
    for (int y = 0; y < 320; ++y) {
      const bool gap = x % 40 == 0 ? y < 12 : y >= 308;
      if (!gap) scene.grid.values[scene.grid.geometry.index({x, y})] = 100;
    }
  }
  scene.x_lines = 17;
  scene.y_lines = 13;
  return scene;
}

class EveryPlanner : public testing::TestWithParam<std::string> {
 protected:
  EveryPlanner() { request_.planner = GetParam(); }

  /// How long an answer took; it must be the path or the status.
  steady_clock::duration timeOf(PlanStatus status) const {
    const auto begin = steady_clock::now();
    const Plan plan = planner_.plan(request_);
    EXPECT_TRUE(plan.status == status || plan.status == PlanStatus::kSuccess)
        << toString(plan.status) << ": " << plan.message;
    EXPECT_EQ(plan.path_map.empty(), plan.status != PlanStatus::kSuccess);
    return steady_clock::now() - begin;
  }

  const Scene scene_ = meander();
  const Planner planner_{test::mapOf(scene_), PlannerParams{}};
  PlanRequest request_ = test::requestFrom(scene_.at(10, 160), scene_.at(310, 160));
};

TEST_P(EveryPlanner, P10_EndsSoonAfterItsTimeout) {
  for (const double timeout : {1e-6, 0.03}) {
    request_.timeout = timeout;
    EXPECT_LT(timeOf(PlanStatus::kTimeout), kGenerous);
  }
}

TEST_P(EveryPlanner, P14_EndsSoonAfterAnotherThreadCancelsIt) {
  request_.timeout = 60;
  std::atomic<bool> cancelled{false};
  request_.cancelled = &cancelled;
  std::thread canceller([&] {
    std::this_thread::sleep_for(milliseconds(30));
    cancelled = true;
  });
  EXPECT_LT(timeOf(PlanStatus::kCancelled), kGenerous);
  canceller.join();
}

INSTANTIATE_TEST_SUITE_P(ByName, EveryPlanner, testing::ValuesIn(plannerNames()),
                         [](const auto& info) { return info.param; });

TEST(PlanRequest, P10_PreparingAnotherRadiusEndsWithTheTimeToo) {
  const Scene scene = meander();
  const Planner planner(test::mapOf(scene), PlannerParams{});
  PlanRequest request = test::requestFrom(scene.at(10, 160), scene.at(310, 160));
  request.timeout = 1e-6;
  request.robot_radius = 0.11;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kTimeout);
  EXPECT_EQ(planner.routes(request, 3).status, PlanStatus::kTimeout);
  // what was begun and left does no harm
  request.timeout = 60;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kSuccess);
  EXPECT_EQ(planner.routes(request, 3).status, PlanStatus::kSuccess);
}

}  // namespace
}  // namespace agrid
