// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "answers_fixture.h"
#include "ros/question_answers.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using Answers = test::AnswersFixture;

TEST_F(Answers, PathThroughTheDoor) {
  const auto response = pathTo(at(9.5, 3.5));
  ASSERT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
  EXPECT_EQ(response.route.names, (std::vector<std::string>{areaAt(2.5, 3.5), areaAt(9.5, 3.5)}));
  EXPECT_EQ(response.route.doors.size(), 1U);
  EXPECT_NEAR(response.length, 7, 0.01);
  EXPECT_LE(response.length_bound, response.length + 1e-9);
  EXPECT_NEAR(response.path.poses.back().pose.position.x, 9.5, 1e-3);
  EXPECT_EQ(response.path.header.frame_id, "map");
  EXPECT_EQ(response.map_id, snapshot_.map->map().digest());
  EXPECT_FALSE(response.cells.empty());
  EXPECT_GT(response.clearance, 0.2);
}

TEST_F(Answers, GoalByCategoryIsTheNearestOfIt) {
  agrid_map::PlanPath::Request request;
  request.start = at(2.5, 3.5);
  request.goal_name = "room";
  const auto response = answerPlanPath(ground_, request);
  ASSERT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
  EXPECT_EQ(response.route.names.back(), areaAt(2.5, 3.5));
  EXPECT_EQ(response.length, 0);
}

TEST_F(Answers, GoalByGuessedCategorySaysSo) {
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  for (agrid::Area& area : map->area_map.areas) area.category.clear();
  snapshot_.map = map;
  agrid_map::PlanPath::Request path;
  path.start = at(2.5, 3.5);
  path.goal_name = "room";
  const auto by_path = answerPlanPath(ground_, path);
  ASSERT_EQ(by_path.status.code, int{Status::SUCCESS}) << by_path.status.message;
  EXPECT_EQ(by_path.route.names.back(), areaAt(2.5, 3.5));
  EXPECT_NE(by_path.status.message.find("guess"), std::string::npos);
  agrid_map::PlanAreas::Request areas;
  areas.start_pose = at(2.5, 3.5);
  areas.goal = "room";
  EXPECT_NE(answerPlanAreas(ground_, areas).status.message.find("guess"), std::string::npos);
  agrid_map::WhereIs::Request where;
  where.start = at(2.5, 3.5);
  where.name = "room";
  const auto found = answerWhereIs(ground_, where);
  ASSERT_EQ(found.matches.size(), 3U);
  EXPECT_EQ(found.matches[0].category, "");
  // the third cannot be reached, and the message tells both
  EXPECT_NE(found.status.message.find("guess"), std::string::npos);
  EXPECT_NE(found.status.message.find("; "), std::string::npos);
}

TEST_F(Answers, AreasByNameAndByPose) {
  agrid_map::PlanAreas::Request request;
  request.start = areaAt(2.5, 3.5);
  request.goal = areaAt(9.5, 3.5);
  const auto by_name = answerPlanAreas(ground_, request);
  ASSERT_EQ(by_name.status.code, int{Status::SUCCESS}) << by_name.status.message;
  ASSERT_EQ(by_name.routes.size(), 1U);
  EXPECT_EQ(by_name.routes[0].names, (std::vector<std::string>{request.start, request.goal}));
  request.start.clear();
  request.goal.clear();
  request.start_pose = at(2.5, 3.5);
  request.goal_pose = at(9.5, 3.5);
  request.max_routes = 5;
  const auto by_pose = answerPlanAreas(ground_, request);
  ASSERT_EQ(by_pose.routes.size(), 1U);
  EXPECT_EQ(by_pose.routes[0].doors, by_name.routes[0].doors);
  request.goal = areaAt(14.5, 3.5);
  EXPECT_EQ(answerPlanAreas(ground_, request).status.code, int{Status::NO_ROUTE});
}

TEST_F(Answers, StartNameThatMeansSeveralThings) {
  auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
  map->area_map.areas.at(0).name = "ROOM";
  map->area_map.areas.at(1).name = "Room";
  snapshot_.map = map;
  agrid_map::PlanAreas::Request request;
  request.start = "rOOm";
  request.goal_pose = at(9.5, 3.5);
  EXPECT_EQ(codeThrown([&] { answerPlanAreas(ground_, request); }), int{Status::START_INVALID});
}

TEST_F(Answers, MakePlanSaysWhyThereIsNone) {
  nav_msgs::GetPlan::Request request;
  request.start = at(2.5, 3.5);
  request.goal = at(9.5, 3.5);
  EXPECT_GE(answerMakePlan(ground_, request).plan.poses.size(), 2U);
  request.goal = at(14.5, 3.5);
  EXPECT_EQ(codeThrown([&] { answerMakePlan(ground_, request); }), int{Status::NO_ROUTE});
}

TEST_F(Answers, LabelAtAPoint) {
  agrid_map::LabelAt::Request request;
  request.point.point.x = 2.5;
  request.point.point.y = 3.5;
  const auto response = answerLabelAt(ground_, request);
  EXPECT_EQ(response.symbols, (std::vector<std::string>{areaAt(2.5, 3.5), "room"}));
  const agrid::Cell cell{static_cast<int>(response.row), static_cast<int>(response.column)};
  EXPECT_EQ(snapshot_.map->grid().cellAt({2.5, 3.5}), cell);
  EXPECT_NEAR(response.center.x, snapshot_.map->grid().cellCenter(cell).x(), 1e-12);
  request.point.point.x = -0.01;
  EXPECT_EQ(codeThrown([&] { answerLabelAt(ground_, request); }), int{Status::OUTSIDE});
  request.point.point.x = std::nan("");
  EXPECT_EQ(codeThrown([&] { answerLabelAt(ground_, request); }), int{Status::INVALID_REQUEST});
}

TEST_F(Answers, WhereIsOrdersByPath) {
  agrid_map::WhereIs::Request request;
  request.name = "room";
  request.start = at(9.5, 3.5);
  const auto response = answerWhereIs(ground_, request);
  ASSERT_EQ(response.matches.size(), 2U);
  EXPECT_EQ(response.matches[0].name, areaAt(9.5, 3.5));
  EXPECT_EQ(response.matches[1].name, areaAt(2.5, 3.5));
  EXPECT_EQ(response.distances[0], 0);
  EXPECT_GT(response.distances[1], 2);
}

TEST_F(Answers, WhereIsWithoutAWay) {
  agrid_map::WhereIs::Request request;
  request.name = areaAt(14.5, 3.5);
  request.start = at(9.5, 3.5);
  const auto response = answerWhereIs(ground_, request);
  EXPECT_EQ(response.status.code, int{Status::SUCCESS});
  EXPECT_FALSE(response.status.message.empty());
  ASSERT_EQ(response.distances.size(), 1U);
  EXPECT_EQ(response.distances[0], std::numeric_limits<double>::infinity());
}

TEST_F(Answers, ARouteToAnObjectEndsWhereThePathDoes) {
  const auto walls_between = agrid::Point2(6.4, 5);  // nearer to the left room
  for (const agrid::Point2& center : {walls_between, agrid::Point2(9.5, 3.5), {7.1, 5}, {1.2, 1}}) {
    auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
    agrid::ObjectTag fridge;
    fridge.name = "fridge";
    fridge.pose_map = {center, 0};
    fridge.size = {0.6, 0.4};
    map->knowledge.objects = {fridge};
    snapshot_.map = map;
    for (const double x : {2.5, 9.5}) {
      agrid_map::PlanPath::Request to_path;
      to_path.start = at(x, 3.5);
      to_path.goal_name = "fridge";
      const auto path = answerPlanPath(ground_, to_path);
      agrid_map::PlanAreas::Request to_areas;
      to_areas.start_pose = to_path.start;
      to_areas.goal = to_path.goal_name;
      const auto list = answerPlanAreas(ground_, to_areas);
      ASSERT_EQ(list.status.code, int{Status::SUCCESS}) << list.status.message;
      EXPECT_EQ(list.status.message, path.status.message);
      EXPECT_EQ(list.routes.at(0).areas, path.route.areas) << center.x() << ", from " << x;
    }
    agrid_map::PlanPath::Request to_path;  // from too close to the wall
    to_path.start = at(2.5, 1.05);
    to_path.goal_name = "fridge";
    EXPECT_EQ(answerPlanPath(ground_, to_path).status.code, int{Status::START_INVALID});
    to_path.tolerance = 0.1;  // the robot's radius is 0.2 m
    EXPECT_EQ(answerPlanPath(ground_, to_path).status.code, int{Status::START_INVALID});
    agrid_map::PlanAreas::Request to_areas;
    to_areas.start_pose = to_path.start;
    to_areas.goal = "fridge";
    EXPECT_EQ(answerPlanAreas(ground_, to_areas).status.code, int{Status::START_INVALID});
  }
}

TEST_F(Answers, APathToAnObjectEndsBesideItAndFacesIt) {
  const agrid::Point2 places[] = {{9.5, 3.5}, {8, 5.8}, {7.2, 1.2}, {10, 6.05}, {7.1, 5}};
  for (const agrid::Point2& center : places) {  // in the open, at walls, in a corner, in a wall
    auto map = std::make_shared<agrid::SemanticMap>(*snapshot_.map);
    agrid::ObjectTag fridge;
    fridge.name = "fridge";
    fridge.pose_map = {center, 0.3};
    fridge.size = {0.6, 0.4};
    map->knowledge.objects = {fridge};
    snapshot_.map = map;
    agrid_map::PlanPath::Request request;
    request.start = at(2.5, 3.5);
    request.goal_name = "fridge";
    const auto response = answerPlanPath(ground_, request);
    ASSERT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
    EXPECT_NE(response.status.message.find("faces it"), std::string::npos);
    request.start = at(2.5, 1.05);  // too close to the wall
    request.tolerance = 0.5;
    const auto moved = answerPlanPath(ground_, request);
    EXPECT_TRUE(moved.start_moved);
    EXPECT_NE(moved.status.message.find("faces it"), std::string::npos) << moved.status.message;
    const agrid::Pose2 last = fromMsg(response.path.poses.back().pose);
    const agrid::Point2 look = center - last.position;
    EXPECT_NEAR(std::remainder(last.yaw - std::atan2(look.y(), look.x()), 2 * M_PI), 0, 1e-3);
    EXPECT_EQ(areaAt(last.position.x(), last.position.y()), areaAt(9.5, 3.5));
    const agrid::Point2 local = inverse(fridge.pose_map) * last.position;
    const double gap = (local.cwiseAbs() - fridge.size / 2).cwiseMax(0).matrix().norm();
    EXPECT_GT(gap, 0.1);
    EXPECT_LT(gap, 1.3);
    EXPECT_GT(response.clearance, 0.1);
  }
}

}  // namespace
}  // namespace agrid_map_ros
