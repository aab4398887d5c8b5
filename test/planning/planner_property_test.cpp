// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include <gtest/gtest.h>

#include "planning/random_trial.h"

namespace agrid {
namespace {

using test::randomTrial;
using test::SlowFreeSpace;
using test::Trial;

TEST(Planner, P15_FindsAFreePathExactlyWhereAFloodFillConnects) {
  std::mt19937 random(20240607);
  int found = 0;
  int apart = 0;
  for (int i = 0; i < 8000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = randomTrial(random);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    preferFree(random, slow, trial);
    const Planner planner(test::mapOf(trial.scene), trial.params);
    const PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    const Plan plan = planner.plan(request);
    EXPECT_EQ(planner.routes(request, 1).status, plan.status);
    if (!slow.isFree(trial.start)) {
      EXPECT_EQ(plan.status, PlanStatus::kStartInvalid);
    } else if (!slow.isFree(trial.goal)) {
      EXPECT_EQ(plan.status, PlanStatus::kGoalInvalid);
    } else if (!slow.connects(trial.start, trial.goal)) {
      EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
      ++apart;
    } else {
      ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
      test::checkPath(trial, slow, plan);
      ++found;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(apart, 300);
}

TEST(Planner, P18_TheSameRequestGivesTheSamePath) {
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    Trial trial = randomTrial(random);
    preferFree(random, {trial.scene, trial.params, trial.params.robot_radius}, trial);
    const auto map = test::mapOf(trial.scene);
    PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    request.seed = 9;
    if (i % 2 == 0) request.planner = "RRTConnect";
    const Plan a = Planner(map, trial.params).plan(request);
    const Plan b = Planner(map, trial.params).plan(request);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.path_map.size(), b.path_map.size());
    for (std::size_t k = 0; k < a.path_map.size(); ++k) {
      EXPECT_EQ(a.path_map[k].position, b.path_map[k].position);
    }
  }
}

}  // namespace
}  // namespace agrid
