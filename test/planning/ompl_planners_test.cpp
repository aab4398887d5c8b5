// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "planning/ompl/planner_by_name.h"
#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using test::Scene;

Scene twoRooms() {
  Scene scene = test::sceneOf({"#####################",  //
                               "#.........#.........#",  //
                               "#.........#.........#",  //
                               "#.........#.........#",  //
                               "#.........#.........#",  //
                               "#...................#",  //
                               "#...................#",  //
                               "#...................#",  //
                               "#.........#.........#",  //
                               "#####################"});
  scene.x_lines = 4;
  scene.y_lines = 2;
  return scene;
}

class OmplPlanners : public testing::TestWithParam<std::string> {};

TEST_P(OmplPlanners, P17_FindAFreePathOrNoneNeverAnApproximateOne) {
  const Scene scene = twoRooms();
  PlannerParams params;
  params.robot_radius = 0.5;
  params.timeout = 2;
  const Planner planner(test::mapOf(scene), params);
  const test::SlowFreeSpace slow(scene, params, params.robot_radius);
  PlanRequest request = test::requestFrom(scene.at(2, 7), scene.at(18, 7));
  request.planner = GetParam();
  for (const double timeout : {2.0, 1e-3}) {
    request.timeout = timeout;
    const Plan plan = planner.plan(request);
    if (timeout == 2.0) {
      ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
    }
    if (plan.status != PlanStatus::kSuccess) {
      EXPECT_EQ(plan.status, PlanStatus::kTimeout);
      continue;
    }
    EXPECT_NEAR((plan.path_map.front().position - scene.at(2, 7)).norm(), 0, 1e-9);
    EXPECT_NEAR((plan.path_map.back().position - scene.at(18, 7)).norm(), 0, 1e-9);
    for (std::size_t i = 1; i < plan.path_map.size(); ++i) {
      EXPECT_FALSE(slow.touchesBlocked(plan.path_map[i - 1].position, plan.path_map[i].position));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ByName, OmplPlanners, testing::ValuesIn(planning::omplPlannerNames()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace agrid
