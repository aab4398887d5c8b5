// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/planner.h"

#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "planning/three_rooms.h"

namespace agrid {
namespace {

using test::planIn;
using test::pointRobot;
using test::requestFrom;
using test::Scene;
using test::threeRooms;

TEST(Planner, SaysWhichAreasDoorsAndCellsThePathCrosses) {
  const Scene scene = threeRooms();
  const Plan plan = planIn(scene, pointRobot(), requestFrom(scene.at(2, 8), scene.at(14, 8)));
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  EXPECT_EQ(plan.route.areas, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(plan.route.doors, std::vector<std::size_t>{0});
  EXPECT_DOUBLE_EQ(plan.route.length, plan.length);
  const auto held_grid = test::gridOf(scene);
  const AGrid& grid = *held_grid;
  EXPECT_EQ(plan.cells.front(), grid.index(*grid.cellAt(scene.at(2, 8))));
  EXPECT_EQ(plan.cells.back(), grid.index(*grid.cellAt(scene.at(14, 8))));
  for (std::size_t i = 1; i < plan.cells.size(); ++i) {
    const Cell a = grid.cell(plan.cells[i - 1]);
    const Cell b = grid.cell(plan.cells[i]);
    EXPECT_EQ(std::max(std::abs(a.row - b.row), std::abs(a.column - b.column)), 1);
  }
  EXPECT_GT(plan.length, 12);
  EXPECT_GE(plan.length_bound, 12);
}

TEST(Planner, MeasuresTheClearanceToTheObstaclesSquares) {
  const Scene scene = test::sceneOf({"#########",  //
                                     "#.......#",  //
                                     "#.......#",  //
                                     "#.......#",  //
                                     "####.####",  //
                                     "#########"});
  const Plan plan = planIn(scene, pointRobot(), requestFrom(scene.at(2, 3), scene.at(6, 3)));
  ASSERT_EQ(plan.status, PlanStatus::kSuccess);
  EXPECT_NEAR(plan.clearance, 1.5, 1e-9);
}

TEST(Planner, P1_StartIsGoal) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(2, 4));
  std::get<PlanPoint>(request.goal).yaw = 1.25;
  const Plan plan = planIn(scene, pointRobot(), request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess);
  ASSERT_EQ(plan.path_map.size(), 1U);
  EXPECT_EQ(plan.length, 0);
  EXPECT_EQ(plan.path_map.front().yaw, 1.25);
  EXPECT_EQ(plan.cells.size(), 1U);
}

TEST(Planner, P3_StartOrGoalInAnObstacleIsMovedWithinTheToleranceOnly) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  PlanRequest request = requestFrom(scene.at(0, 4), scene.at(14, 9));
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kStartInvalid);
  request.tolerance = 0.99;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kStartInvalid);
  request.tolerance = 1;
  const Plan plan = planner.plan(request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  EXPECT_TRUE(plan.start_moved);
  EXPECT_TRUE(plan.goal_moved);
  EXPECT_NEAR((plan.path_map.front().position - scene.at(1, 4)).norm(), 0, 1e-9);
  EXPECT_NEAR((plan.path_map.back().position - scene.at(14, 8)).norm(), 0, 1e-9);
}

TEST(Planner, P3_AMoveNeverEndsBehindAWallWhenItNeedNot) {
  // The wall's nearest free pixel lies below it, in the closed room; the start is above.
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(5, 2) - Point2(0, 0.1));
  request.tolerance = 1.5;
  const Plan plan = planIn(scene, pointRobot(), request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  EXPECT_NEAR((plan.path_map.back().position - scene.at(5, 3)).norm(), 0, 1e-9);
}

TEST(Planner, P4_UnknownSpaceIsAnObstacleUnlessAllowed) {
  const Scene scene = test::sceneOf({".......",  //
                                     "...?...",  //
                                     "...?...",  //
                                     "...?...",  //
                                     "......."});
  PlannerParams params = pointRobot();
  const PlanRequest across = requestFrom(scene.at(1, 2), scene.at(5, 2));
  const PlanRequest into = requestFrom(scene.at(1, 2), scene.at(3, 2));
  EXPECT_EQ(planIn(scene, params, across).status, PlanStatus::kNoRoute);
  EXPECT_EQ(planIn(scene, params, into).status, PlanStatus::kGoalInvalid);
  params.allow_unknown = true;
  EXPECT_EQ(planIn(scene, params, across).status, PlanStatus::kSuccess);
  EXPECT_EQ(planIn(scene, params, into).status, PlanStatus::kSuccess);
}

TEST(Planner, P5_AnotherComponentIsRefusedBeforeAnyPlannerRuns) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(2, 1));
  request.planner = "RRTstar";
  const Plan plan = planIn(scene, pointRobot(), request);
  EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
  EXPECT_LT(plan.planning_time, PlannerParams{}.timeout / 2);
}

TEST(Planner, P6_AClosedDoorIsNamedAndOpeningItHelps) {
  Scene scene = threeRooms();
  const PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  scene.doors[0].state = DoorState::kClosed;
  const Plan plan = planIn(scene, pointRobot(), request);
  EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
  EXPECT_NE(plan.message.find("closed door 'the door'"), std::string::npos) << plan.message;
  EXPECT_EQ(Planner(test::mapOf(scene), pointRobot()).routes(request, 3).status,
            PlanStatus::kNoRoute);
  scene.doors[0].state = DoorState::kOpen;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kSuccess);
}

TEST(Planner, P6_ATooNarrowDoorIsNamed) {
  const Scene scene = threeRooms();
  PlannerParams params;
  params.robot_radius = 2;
  const Plan plan = planIn(scene, params, requestFrom(scene.at(4, 6), scene.at(13, 6)));
  EXPECT_EQ(plan.status, PlanStatus::kNoRoute);
  EXPECT_NE(plan.message.find("too narrow door 'the door'"), std::string::npos) << plan.message;
}

TEST(Planner, P6_NothingSlipsPastAClosedDoorAtAnyAngle) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  for (int trial = 0; trial < 200; ++trial) {
    Scene scene;
    scene.grid.geometry = {21, 21, 1, {{3, 4}, angle(random)}};
    scene.grid.values.assign(21 * 21, 0);
    scene.areas.assign(21, std::string(21, ' '));
    const double a = angle(random);
    const Point2 along(std::cos(a), std::sin(a));
    const Point2 middle(10.3, 10.1);
    // Far beyond the map at both ends.
    Door door;
    door.state = DoorState::kClosed;
    const Point2 from = middle - 40 * along;
    const Point2 to = middle + 40 * along;
    door.jambs_map = {scene.at(from.x(), from.y()), scene.at(to.x(), to.y())};
    scene.doors = {door};
    const Point2 across(-along.y(), along.x());
    const Point2 s = middle + 4 * across;
    const Point2 g = middle - 4 * across;
    const PlanRequest request = requestFrom(scene.at(s.x(), s.y()), scene.at(g.x(), g.y()));
    EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kNoRoute) << trial;
    scene.doors.clear();
    EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kSuccess) << trial;
  }
}

TEST(Planner, GoesToTheNearestPointOfAnAreaOrToItsAnchor) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  PlanRequest request = requestFrom(scene.at(2, 5), Point2::Zero());
  request.goal = AreaGoal{AreaId{2}, false};
  Plan plan = planner.plan(request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  EXPECT_NEAR((plan.path_map.back().position - scene.at(8, 5)).norm(), 0, 1e-9);
  request.goal = AreaGoal{AreaId{2}, true};
  plan = planner.plan(request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  const Point2 anchor = test::mapOf(scene)->area_map.areas[1].anchor_map;
  EXPECT_NEAR((plan.path_map.back().position - anchor).norm(), 0, 1e-9);
  request.goal = AreaGoal{AreaId{1}, false};
  plan = planner.plan(request);
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  EXPECT_EQ(plan.path_map.size(), 1U);
}

TEST(Planner, HeadingsFollowThePathAndEndAsAsked) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 8), scene.at(14, 8));
  Plan plan = planIn(scene, pointRobot(), request);
  ASSERT_GT(plan.path_map.size(), 2U);
  EXPECT_EQ(plan.path_map.back().yaw, plan.path_map[plan.path_map.size() - 2].yaw);
  request.start.yaw = 2;
  std::get<PlanPoint>(request.goal).yaw = -1;
  plan = planIn(scene, pointRobot(), request);
  EXPECT_EQ(plan.path_map.front().yaw, 2);
  EXPECT_EQ(plan.path_map.back().yaw, -1);
}

TEST(Planner, AnswersSeveralThreadsAndRadiiAtOnce) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 40; ++i) {
        PlanRequest request = requestFrom(scene.at(3, 5), scene.at(13, 5));
        request.robot_radius = 0.25 * ((i + t) % 8);
        const bool fits = *request.robot_radius < 2;
        const PlanStatus expected = fits ? PlanStatus::kSuccess : PlanStatus::kNoRoute;
        if (planner.plan(request).status != expected) ++wrong;
        if (planner.routes(request, 2).status != expected) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace agrid
