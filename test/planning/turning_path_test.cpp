// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/turning_path.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "planning/drive_oracle.h"

namespace agrid {
namespace {

using test::driven;
using test::fill;
using test::hall;
using test::halls;
using test::kPi;
using test::kResolution;
using test::request;
using test::Scene;
using test::turned;

PlannerParams car() {
  PlannerParams params;
  params.robot_radius = 0.2;
  params.turning_radius = 0.5;
  params.timeout = 30;
  return params;
}

bool drivesBackwards(const Plan& plan) {
  for (std::size_t i = 1; i < plan.path_map.size(); ++i) {
    if (driven(plan.path_map[i - 1], plan.path_map[i]) < -1e-6) return true;
  }
  return false;
}

/// The path can be driven, is free, and starts and ends as asked.
void expectDrivable(const Scene& scene, const PlannerParams& params, const PlanRequest& request,
                    const Plan& plan) {
  ASSERT_EQ(plan.status, PlanStatus::kSuccess) << plan.message;
  const auto& path = plan.path_map;
  const auto& goal = std::get<PlanPoint>(request.goal);
  EXPECT_NEAR((path.front().position - request.start.position_map).norm(), 0, 1e-5);
  EXPECT_NEAR((path.back().position - goal.position_map).norm(), 0, 1e-5);
  const Pose2 start_heading{{0, 0}, request.start.yaw.value_or(path.front().yaw)};
  const Pose2 goal_heading{{0, 0}, goal.yaw.value_or(path.back().yaw)};
  EXPECT_LT(turned(path.front(), start_heading), 1e-5);
  EXPECT_LT(turned(path.back(), goal_heading), 1e-5);
  const test::SlowFreeSpace slow(scene, params, params.robot_radius);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double way = (path[i].position - path[i - 1].position).norm();
    EXPECT_LE(way, 2 * kResolution + 1e-5);
    // never sideways, and never sharper than the turning radius: a chord is a hair shorter
    EXPECT_NEAR(std::abs(driven(path[i - 1], path[i])), way, 1e-4);
    EXPECT_LE(turned(path[i - 1], path[i]) * params.turning_radius, way * 1.01 + 1e-4);
    EXPECT_FALSE(slow.touchesBlocked(path[i - 1].position, path[i].position));
  }
  EXPECT_GE(plan.length, plan.length_bound);
  EXPECT_FALSE(plan.cells.empty());
}

TEST(TurningPath, TurnsAroundInADeadEnd) {
  std::vector<std::string> rows = hall(60, 30);
  fill(rows, 20, 60, 0, 11);
  fill(rows, 20, 60, 19, 30);  // a corridor of 0.8 m, closed at its end
  const Scene scene = halls(rows);
  const auto wanted = request(scene, {55, 15}, 0, {10, 15}, kPi);  // nose to the dead end
  const Plan plan = Planner(test::mapOf(scene), car()).plan(wanted);
  expectDrivable(scene, car(), wanted, plan);
  EXPECT_TRUE(drivesBackwards(plan));
  EXPECT_LT(plan.length, 1.6 * plan.length_bound);
}

TEST(TurningPath, ForwardsAloneIsOutOfTimeInADeadEndAndNeverANo) {
  std::vector<std::string> rows = hall(60, 30);
  fill(rows, 20, 60, 0, 11);
  fill(rows, 20, 60, 19, 30);
  const Scene scene = halls(rows);
  PlannerParams params = car();
  params.motion = Motion::kDubins;
  params.timeout = 0.1;
  const Planner planner(test::mapOf(scene), params);
  EXPECT_EQ(planner.plan(request(scene, {55, 15}, 0, {10, 15}, kPi)).status, PlanStatus::kTimeout);
  const auto wanted = request(scene, {10, 15}, 0, {55, 15}, 0);
  PlanRequest patient = wanted;
  patient.timeout = 30;
  const Plan plan = planner.plan(patient);
  expectDrivable(scene, params, wanted, plan);
  EXPECT_FALSE(drivesBackwards(plan));
}

TEST(TurningPath, ObeysHeadingsThatAreParallelAndOpposite) {
  const Scene scene = halls(hall(70, 50));
  for (const Motion motion : {Motion::kReedsShepp, Motion::kDubins}) {
    PlannerParams params = car();
    params.motion = motion;
    const Planner planner(test::mapOf(scene), params);
    for (const double yaw : {0.0, kPi / 2, kPi, -kPi / 2}) {
      for (const double goal_yaw : {yaw, yaw + kPi}) {
        const auto wanted = request(scene, {30, 25}, yaw, {36, 25}, goal_yaw);
        const Plan plan = planner.plan(wanted);
        expectDrivable(scene, params, wanted, plan);
        EXPECT_FALSE(motion == Motion::kDubins && drivesBackwards(plan));
      }
    }
  }
}

TEST(TurningPath, HeadingsThatAreNotAskedForAreFree) {
  const Scene scene = halls(hall(70, 50));
  const Planner planner(test::mapOf(scene), car());
  auto wanted = request(scene, {10, 10}, 0, {10, 40}, 0);
  wanted.start.yaw.reset();
  std::get<PlanPoint>(wanted.goal).yaw.reset();
  const Plan plan = planner.plan(wanted);
  expectDrivable(scene, car(), wanted, plan);
  EXPECT_NEAR(plan.length, 3, 1e-4);  // straight
}

TEST(TurningPath, StartIsGoalTurnsOnlyIfAnotherHeadingIsAsked) {
  const Scene scene = halls(hall(70, 50));
  const Planner planner(test::mapOf(scene), car());
  const auto around = request(scene, {30, 25}, 0, {30, 25}, kPi);
  const Plan plan = planner.plan(around);
  expectDrivable(scene, car(), around, plan);
  EXPECT_GT(plan.length, 1);
  const Plan still = planner.plan(request(scene, {30, 25}, 0.5, {30, 25}, 0.5));
  EXPECT_EQ(still.status, PlanStatus::kSuccess);
  EXPECT_NEAR(still.length, 0, 1e-6);
}

TEST(TurningPath, P18_TheSeedRepeatsThePath) {
  std::vector<std::string> rows = hall(60, 40);
  fill(rows, 20, 24, 0, 28);
  fill(rows, 40, 44, 12, 40);
  const Scene scene = halls(rows);
  auto wanted = request(scene, {10, 10}, 1, {52, 30}, 2);
  std::vector<Plan> plans;
  for (const std::uint32_t seed : {7U, 7U, 8U}) {
    wanted.seed = seed;
    plans.push_back(Planner(test::mapOf(scene), car()).plan(wanted));
    expectDrivable(scene, car(), wanted, plans.back());
  }
  ASSERT_EQ(plans[0].path_map.size(), plans[1].path_map.size());
  for (std::size_t i = 0; i < plans[0].path_map.size(); ++i) {
    EXPECT_EQ(plans[0].path_map[i].position, plans[1].path_map[i].position);
    EXPECT_EQ(plans[0].path_map[i].yaw, plans[1].path_map[i].yaw);
  }
  EXPECT_NE(plans[0].length, plans[2].length);
}

TEST(TurningPath, P14_CancelledWhileItSearches) {
  std::vector<std::string> rows = hall(60, 30);
  fill(rows, 20, 60, 0, 11);
  fill(rows, 20, 60, 19, 30);
  const Scene scene = halls(rows);
  PlannerParams params = car();
  params.motion = Motion::kDubins;  // there is no such path, and nobody can prove it
  params.timeout = 60;
  const Planner planner(test::mapOf(scene), params);
  auto wanted = request(scene, {55, 15}, 0, {10, 15}, kPi);
  std::atomic<bool> cancelled{false};
  wanted.cancelled = &cancelled;
  std::thread canceller([&cancelled] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    cancelled = true;
  });
  const Plan plan = planner.plan(wanted);
  canceller.join();
  EXPECT_EQ(plan.status, PlanStatus::kCancelled);
  EXPECT_LT(plan.planning_time, 30);
}

TEST(TurningPath, P5_NoWayForTheCircleIsNoWayForTheCar) {
  std::vector<std::string> rows = hall(60, 30);
  fill(rows, 30, 31, 0, 30);
  const Scene scene = halls(rows);
  const auto wanted = request(scene, {10, 15}, 0, {50, 15}, 0);
  EXPECT_EQ(Planner(test::mapOf(scene), car()).plan(wanted).status, PlanStatus::kNoRoute);
}

TEST(TurningPath, GoesThroughRandomPlansWhereverTheLeadDoes) {
  std::mt19937 random(11);
  int found = 0;
  for (int round = 0; round < 12; ++round) {
    Scene scene;
    scene.grid = test::randomPlan(random, {60, 50, kResolution, {{1, 2}, -0.7}});
    PlannerParams params = car();
    params.robot_radius = 0.15;
    const Planner planner(test::mapOf(scene), params);
    for (int i = 0; i < 4; ++i) {
      const auto wanted = test::requestFrom(
          scene.at(static_cast<double>(random() % 60), static_cast<double>(random() % 50)),
          scene.at(static_cast<double>(random() % 60), static_cast<double>(random() % 50)));
      PlanRequest circle = wanted;
      circle.turning_radius = 0;
      if (planner.plan(circle).status != PlanStatus::kSuccess) continue;
      expectDrivable(scene, params, wanted, planner.plan(wanted));
      ++found;
    }
  }
  EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace agrid
