// SPDX-License-Identifier: BSD-3-Clause
#include "planning/request_check.h"

#include <atomic>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "planning/three_rooms.h"

namespace agrid {
namespace {

using test::planIn;
using test::pointRobot;
using test::requestFrom;
using test::Scene;
using test::threeRooms;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PlanRequest, P2_StartOrGoalNotFiniteOrOutside) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  const Point2 good = scene.at(2, 4);
  for (const Point2& bad : {Point2(kNan, 0), Point2(0, kInfinity), Point2(-1, 4), Point2(1e9, 4)}) {
    PlanRequest request = requestFrom(bad, good);
    request.tolerance = 100;
    EXPECT_EQ(planner.plan(request).status, PlanStatus::kStartInvalid);
    EXPECT_FALSE(planner.plan(request).message.empty());
    EXPECT_EQ(planner.plan(requestFrom(good, bad)).status, PlanStatus::kGoalInvalid);
  }
}

TEST(PlanRequest, P7_UnknownAreaAndAreaWithoutRoom) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(4, 4), Point2::Zero());
  request.goal = AreaGoal{AreaId{99}, false};
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kUnknownName);
  request.goal = AreaGoal{AreaId{3}, false};
  request.robot_radius = 1;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kGoalInvalid);
  request.robot_radius = 0;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kNoRoute);
}

TEST(PlanRequest, P9_RadiusOfTheRequestAndOfTheParameters) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  for (const double bad : {-1.0, kNan, kInfinity}) {
    request.robot_radius = bad;
    const Plan plan = planner.plan(request);
    EXPECT_EQ(plan.status, PlanStatus::kInvalidRequest);
    EXPECT_NE(plan.message.find("robot_radius"), std::string::npos);
    PlannerParams params;
    params.robot_radius = bad;
    EXPECT_THROW(Planner(test::mapOf(scene), params), std::invalid_argument);
  }
  request.robot_radius = 1e7;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kStartInvalid);
  for (int i = 0; i < 10; ++i) {
    request.robot_radius = i % 6;
    const PlanStatus expected = i % 6 < 2 ? PlanStatus::kSuccess : PlanStatus::kStartInvalid;
    EXPECT_EQ(planner.plan(request).status, expected) << i;
  }
}

TEST(PlanRequest, P10_TimeoutMustLieInItsBounds) {
  const Scene scene = threeRooms();
  const Planner planner(test::mapOf(scene), pointRobot());
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  for (const double bad : {0.0, -1.0, kNan, 1e9, 60.001}) {
    request.timeout = bad;
    EXPECT_EQ(planner.plan(request).status, PlanStatus::kInvalidRequest);
  }
  request.timeout = 1e-9;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kTimeout);
  EXPECT_EQ(planner.routes(request, 1).status, PlanStatus::kTimeout);
}

TEST(PlanRequest, P11_UnknownPlannerListsTheNames) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  request.planner = "Teleport";
  const Plan plan = planIn(scene, pointRobot(), request);
  EXPECT_EQ(plan.status, PlanStatus::kInvalidRequest);
  for (const std::string& name : plannerNames()) {
    EXPECT_NE(plan.message.find(name), std::string::npos) << name;
  }
}

TEST(PlanRequest, P12_NoMapIsRefused) { EXPECT_THROW(Planner(nullptr, {}), std::invalid_argument); }

TEST(PlanRequest, P14_CancelledRequestsEnd) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  const std::atomic<bool> cancelled{true};
  request.cancelled = &cancelled;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kCancelled);
}

TEST(PlanRequest, RefusesWhatItCannotPlanFor) {
  const Scene scene = threeRooms();
  PlanRequest request = requestFrom(scene.at(2, 4), scene.at(14, 4));
  for (const double bad : {-0.5, kNan, kInfinity}) {
    request.turning_radius = bad;
    EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kInvalidRequest);
  }
  request.turning_radius = 0.5;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kSuccess);
  request.planner = "RRTConnect";
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kInvalidRequest);
  request.planner = "AGrid";
  request.turning_radius = 0;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kSuccess);
  request.tolerance = kNan;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kInvalidRequest);
  request.tolerance = 0;
  request.start.yaw = kNan;
  EXPECT_EQ(planIn(scene, pointRobot(), request).status, PlanStatus::kInvalidRequest);
}

}  // namespace
}  // namespace agrid
