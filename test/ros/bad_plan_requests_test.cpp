// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "answers_fixture.h"
#include "ros/question_answers.h"
#include "ros/way_to_things.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using Answers = test::AnswersFixture;

TEST_F(Answers, P1_StartIsGoal) {
  const auto response = pathTo(at(2.5, 3.5));
  EXPECT_EQ(response.status.code, int{Status::SUCCESS});
  EXPECT_EQ(response.length, 0);
}

TEST_F(Answers, P2_P3_StartOrGoalWhereTheRobotCannotBe) {
  EXPECT_EQ(pathTo(at(6.5, 1.5)).status.code, int{Status::GOAL_INVALID});
  EXPECT_EQ(pathTo(at(99, 3.5)).status.code, int{Status::GOAL_INVALID});
  agrid_map::PlanPath::Request request;
  request.goal = at(2.5, 3.5);
  request.start = at(1.05, 3.5);  // free, but within the radius of the wall
  EXPECT_EQ(answerPlanPath(ground_, request).status.code, int{Status::START_INVALID});
  request.tolerance = 0.5;
  const auto response = answerPlanPath(ground_, request);
  EXPECT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
  EXPECT_TRUE(response.start_moved);
  EXPECT_FALSE(response.goal_moved);
}

TEST_F(Answers, P2_NumbersThatAreNone) {
  EXPECT_EQ(codeThrown([&] { pathTo(at(std::nan(""), 1)); }), int{Status::INVALID_REQUEST});
}

TEST_F(Answers, P5_UnreachableIsNoRoute) {
  const auto response = pathTo(at(14.5, 3.5));
  EXPECT_EQ(response.status.code, int{Status::NO_ROUTE});
  EXPECT_FALSE(response.status.message.empty());
  EXPECT_TRUE(response.path.poses.empty());
}

TEST_F(Answers, P6_AClosedDoorIsNamed) {
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  map->area_map.doors.at(0).state = agrid::DoorState::kClosed;
  map->area_map.doors.at(0).name = "the door";
  snapshot_.planner = std::make_shared<const agrid::Planner>(map, agrid::PlannerParams{});
  snapshot_.map = map;
  const auto response = pathTo(at(9.5, 3.5));
  EXPECT_EQ(response.status.code, int{Status::NO_ROUTE});
  EXPECT_NE(response.status.message.find("closed door 'the door'"), std::string::npos)
      << response.status.message;
}

TEST_F(Answers, P7_OfSeveralGoalsOfOneNameTheNearest) {
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  for (agrid::Area& area : map->area_map.areas) area.name = "office";
  snapshot_.map = map;
  agrid_map::PlanPath::Request request;
  request.start = at(9.5, 3.5);
  request.goal_name = "office";
  const auto response = answerPlanPath(ground_, request);
  ASSERT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
  EXPECT_EQ(response.length, 0);
}

TEST_F(Answers, P9_ARadiusOfZeroIsTheParameter) {
  agrid_map::PlanPath::Request request;
  request.start = at(1.05, 3.5);  // within the parameter's radius of the wall
  request.goal = at(9.5, 3.5);
  EXPECT_EQ(answerPlanPath(ground_, request).status.code, int{Status::START_INVALID});
  request.robot_radius = 0.01;
  EXPECT_EQ(answerPlanPath(ground_, request).status.code, int{Status::SUCCESS});
  request.robot_radius = 0;
  agrid::PlannerParams point;
  point.robot_radius = 0;
  snapshot_.planner = std::make_shared<const agrid::Planner>(snapshot_.map, point);
  EXPECT_EQ(answerPlanPath(ground_, request).status.code, int{Status::SUCCESS});
  request.robot_radius = 1e6;
  EXPECT_EQ(answerPlanPath(ground_, request).status.code, int{Status::START_INVALID});
}

TEST_F(Answers, P10_TheTimeoutIsThatOfTheRequestOrTheParameterAndCountsFromTheArrival) {
  Parameters parameters;
  parameters.planner.timeout = 2;
  snapshot_.parameters = std::make_shared<const Parameters>(parameters);
  agrid_map::PlanPath::Request request;
  request.start = at(2.5, 3.5);
  request.goal = at(9.5, 3.5);
  Ground late{snapshot_, frames_, cancelled_, std::chrono::seconds(3)};
  EXPECT_EQ(codeThrown([&] { answerPlanPath(late, request); }), int{Status::TIMEOUT});
  request.timeout = 60;
  EXPECT_EQ(answerPlanPath(late, request).status.code, int{Status::SUCCESS});
  agrid_map::PlanAreas::Request areas;
  areas.start_pose = request.start;
  areas.goal_pose = request.goal;
  EXPECT_EQ(codeThrown([&] { answerPlanAreas(late, areas); }), int{Status::TIMEOUT});
  agrid_map::WhereIs::Request where;
  where.start = request.start;
  where.name = "room";
  EXPECT_EQ(codeThrown([&] { answerWhereIs(late, where); }), int{Status::TIMEOUT});
  nav_msgs::GetPlan::Request make;
  make.start = request.start;
  make.goal = request.goal;
  EXPECT_EQ(codeThrown([&] { answerMakePlan(late, make); }), int{Status::TIMEOUT});
}

TEST_F(Answers, P10_AllGoalsOfANameShareTheTimeout) {
  std::vector<agrid::Thing> things;
  for (const agrid::Area& area : snapshot_.map->area_map.areas) things.push_back(&area);
  agrid::PlanRequest wanted;
  wanted.start.position_map = {2.5, 3.5};
  const TimeLimit over(1, 1, std::chrono::seconds(2));
  const WayFinder late{*snapshot_.planner, over};
  const agrid::Plan plan = late.planToNearest(things, wanted, false);
  EXPECT_EQ(plan.status, agrid::PlanStatus::kTimeout);
  EXPECT_NE(plan.message.find("after 1 of 3 places"), std::string::npos) << plan.message;
  const agrid::RouteList routes = late.routesToNearest(things, wanted, 1);
  EXPECT_EQ(routes.status, agrid::PlanStatus::kTimeout);
  EXPECT_NE(routes.message.find("after 1 of 3 places"), std::string::npos) << routes.message;
  const TimeLimit long_enough(60, 1, {});
  EXPECT_EQ(
      WayFinder({*snapshot_.planner, long_enough}).planToNearest(things, wanted, false).status,
      agrid::PlanStatus::kSuccess);
}

TEST_F(Answers, P16_M20_ANewerMapIsRemarkedBesideWhatElseThereIsToSay) {
  Snapshot newest = snapshot_;
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  map->structure.map = std::make_shared<const agrid::OccupancyMap>(map->map());
  newest.map = map;
  Status status;
  remarkChange(status, snapshot_, &snapshot_);
  EXPECT_EQ(status.message, "");
  remarkChange(status, snapshot_, &newest);
  EXPECT_EQ(status.message, "a newer map has been built meanwhile");
  status.message = "a guess";
  remarkChange(status, snapshot_, &newest);
  EXPECT_EQ(status.message, "a guess; a newer map has been built meanwhile");
}

TEST_F(Answers, P12_M20_AnEditMeanwhileIsNoNewerMap) {
  Snapshot newest = snapshot_;
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  map->area_map.areas.at(0).name = "kitchen";
  newest.map = map;
  ++newest.stamp.version;
  Status status;
  remarkChange(status, snapshot_, &newest);
  EXPECT_EQ(status.message, "what is known has changed meanwhile");
}

TEST_F(Answers, P9_P10_P11_BadNumbersAndNames) {
  agrid_map::PlanPath::Request good;
  good.start = at(2.5, 3.5);
  good.goal = at(9.5, 3.5);
  std::vector<agrid_map::PlanPath::Request> bad(7, good);
  bad[0].robot_radius = -1;
  bad[1].robot_radius = std::nan("");
  bad[2].timeout = -1;
  bad[3].timeout = 1e9;
  bad[4].planner = "RTTConnect";
  bad[5].tolerance = std::nan("");
  bad[6].turning_radius = -1;
  for (const auto& request : bad) {
    const auto response = answerPlanPath(ground_, request);
    EXPECT_EQ(response.status.code, int{Status::INVALID_REQUEST}) << response.status.message;
  }
  EXPECT_NE(answerPlanPath(ground_, bad[4]).status.message.find("RRTConnect"), std::string::npos);
}

TEST_F(Answers, P14_Cancelled) {
  cancelled_ = true;
  EXPECT_EQ(pathTo(at(9.5, 3.5)).status.code, int{Status::CANCELLED});
  agrid_map::WhereIs::Request where;
  where.start = at(2.5, 3.5);
  where.name = "room";
  EXPECT_EQ(codeThrown([&] { answerWhereIs(ground_, where); }), int{Status::CANCELLED});
}

TEST_F(Answers, P18_SameSeedSamePathWithAPlannerOfOmpl) {
  agrid_map::PlanPath::Request request;
  request.start = at(2.5, 5.5);
  request.goal = at(9.5, 5.5);
  request.planner = "RRTConnect";
  request.seed = 3;
  const auto first = answerPlanPath(ground_, request);
  ASSERT_EQ(first.status.code, int{Status::SUCCESS}) << first.status.message;
  EXPECT_EQ(answerPlanPath(ground_, request).path, first.path);
}

TEST_F(Answers, P7_GoalByName) {
  agrid_map::PlanPath::Request request;
  request.start = at(2.5, 3.5);
  request.goal_name = areaAt(9.5, 3.5);
  const auto nearest = answerPlanPath(ground_, request);
  ASSERT_EQ(nearest.status.code, int{Status::SUCCESS}) << nearest.status.message;
  request.goal_at_anchor = true;
  const auto anchor = answerPlanPath(ground_, request);
  EXPECT_LT(nearest.length, anchor.length);
  request.goal_name = "area_99";
  EXPECT_EQ(codeThrown([&] { answerPlanPath(ground_, request); }), int{Status::UNKNOWN_NAME});
  request.goal_name = "a\nb";
  EXPECT_EQ(codeThrown([&] { answerPlanPath(ground_, request); }), int{Status::INVALID_REQUEST});
}

}  // namespace
}  // namespace agrid_map_ros
