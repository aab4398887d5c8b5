// SPDX-License-Identifier: BSD-3-Clause
// The wiring of the nodelet: topics and services. What is answered is tested without a master.
#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/GetPlan.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <agrid_map/AddTag.h>
#include <agrid_map/GetAGrid.h>
#include <agrid_map/ListTags.h>
#include <agrid_map/PlanAreas.h>
#include <agrid_map/RemoveTag.h>
#include <agrid_map/SetDoor.h>
#include <agrid_map/WhereIs.h>

#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using test::eventually;

using Nodelet = test::NodeletClient;

TEST_F(Nodelet, M3_P12_T15_WithoutAMapEveryServiceSaysSo) {
  EXPECT_EQ(ask<agrid_map::GetGraph>("empty/get_graph").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::GetAGrid>("empty/get_agrid").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::LabelAt>("empty/label_at").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::WhereIs>("empty/where_is").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::PlanAreas>("empty/plan_areas").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::PlanPath>("empty/plan_path").status.code, int{Status::NO_MAP});
  EXPECT_TRUE(ask<nav_msgs::GetPlan>("empty/make_plan").plan.poses.empty());
  EXPECT_FALSE(ask<std_srvs::Trigger>("empty/rebuild").success);
  EXPECT_EQ(ask<agrid_map::AddTag>("empty/add_tag").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::RemoveTag>("empty/remove_tag").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::SetDoor>("empty/set_door").status.code, int{Status::NO_MAP});
  EXPECT_EQ(ask<agrid_map::ListTags>("empty/list_tags").status.code, int{Status::NO_MAP});
}

TEST_F(Nodelet, L3_R1_BadParametersAreToldUntilTheyAreMended) {
  useTwoRooms();
  const Status status = ask<agrid_map::GetGraph>("wrong/get_graph").status;
  EXPECT_EQ(status.code, int{Status::INVALID_REQUEST});
  EXPECT_NE(status.message.find("robot_radius"), std::string::npos) << status.message;
  EXPECT_FALSE(ask<std_srvs::Trigger>("wrong/rebuild").success);
  ros::param::set("wrong/robot_radius", 0.3);
  EXPECT_TRUE(eventually([this] { return ask<std_srvs::Trigger>("wrong/rebuild").success; }));
  EXPECT_TRUE(eventually([this] {
    return ask<agrid_map::GetGraph>("wrong/get_graph").status.code == int{Status::SUCCESS};
  }));
}

TEST_F(Nodelet, TopicsAreLatchedAndBelongTogether) {
  useTwoRooms();
  const auto now = graph();
  const auto grid = latched<agrid_map::AGrid>("agrid/agrid");
  const auto graph_message = latched<agrid_map::TopologicalGraph>("agrid/graph");
  const auto markers = latched<visualization_msgs::MarkerArray>("agrid/markers");
  const auto areas = latched<nav_msgs::OccupancyGrid>("agrid/areas");
  ASSERT_TRUE(grid && graph_message && markers && areas);
  EXPECT_EQ(grid->version, now.version);
  EXPECT_EQ(graph_message->version, now.version);
  EXPECT_EQ(graph_message->areas.size(), 3U);
  EXPECT_EQ(graph_message->doors.size(), 1U);
  EXPECT_EQ(areas->info.width, 170U);
  EXPECT_EQ(markers->markers.front().action, int{visualization_msgs::Marker::DELETEALL});
}

TEST_F(Nodelet, EveryServiceAnswers) {
  useTwoRooms();
  const auto grid = ask<agrid_map::GetAGrid>("agrid/get_agrid").agrid;
  EXPECT_EQ(grid.labels.size(), (grid.x.size() - 1) * (grid.y.size() - 1));
  EXPECT_NE(areaAt(2.5, 3.5), areaAt(9.5, 3.5));
  const auto path = ask<agrid_map::PlanPath>("agrid/plan_path", pathRequest());
  EXPECT_EQ(path.status.code, int{Status::SUCCESS}) << path.status.message;
  const auto plan = latched<nav_msgs::Path>("agrid/plan");
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->poses.size(), path.path.poses.size());
  agrid_map::PlanAreas::Request areas;
  areas.start = path.route.names.front();
  areas.goal = path.route.names.back();
  EXPECT_EQ(ask<agrid_map::PlanAreas>("agrid/plan_areas", areas).routes.at(0).doors,
            path.route.doors);
  nav_msgs::GetPlan::Request make;
  make.start = at(2.5, 3.5);
  make.goal = at(9.5, 3.5);
  EXPECT_FALSE(ask<nav_msgs::GetPlan>("agrid/make_plan", make).plan.poses.empty());
  agrid_map::WhereIs::Request where;
  where.name = areas.goal;
  where.start = at(2.5, 3.5);
  EXPECT_EQ(ask<agrid_map::WhereIs>("agrid/where_is", where).matches.size(), 1U);
}

TEST_F(Nodelet, BadRequestsSayWhatIsWrong) {
  useTwoRooms();
  EXPECT_EQ(pathStatus(pathRequest(14.5, 3.5)), int{Status::NO_ROUTE});
  EXPECT_EQ(pathStatus(pathRequest(6.5, 1.5)), int{Status::GOAL_INVALID});
  auto request = pathRequest();
  request.start = at(-5, 0);
  EXPECT_EQ(pathStatus(request), int{Status::START_INVALID});
  request = pathRequest();
  request.planner = "no such planner";
  EXPECT_EQ(pathStatus(request), int{Status::INVALID_REQUEST});
  request = pathRequest();
  request.goal_name = "no such area";
  EXPECT_EQ(pathStatus(request), int{Status::UNKNOWN_NAME});
  request = pathRequest();
  request.goal.header.frame_id = "nowhere";
  EXPECT_EQ(pathStatus(request), int{Status::NO_TRANSFORM});
  agrid_map::LabelAt::Request label;
  label.point.point.x = -1;
  EXPECT_EQ(ask<agrid_map::LabelAt>("agrid/label_at", label).status.code, int{Status::OUTSIDE});
}

TEST_F(Nodelet, TheRobotsPoseByTf) {
  useTwoRooms();
  auto request = pathRequest();
  request.start_from_robot = true;
  placeRobot(2.5, 3.5);
  EXPECT_TRUE(eventually([&] { return pathStatus(request) == int{Status::SUCCESS}; }));
  const auto current = [this] { return latched<agrid_map::Area>("agrid/current_area")->id; };
  const std::uint32_t left = areaAt(2.5, 3.5);
  EXPECT_TRUE(eventually([&] { return current() == left; }));
  placeRobot(9.5, 3.5);
  const std::uint32_t right = areaAt(9.5, 3.5);
  EXPECT_TRUE(eventually([&] { return current() == right; }));
  request = pathRequest();
  request.goal = at(0, 1, "base_link");
  const auto path = ask<agrid_map::PlanPath>("agrid/plan_path", request);
  ASSERT_EQ(path.status.code, int{Status::SUCCESS}) << path.status.message;
  EXPECT_NEAR(path.path.poses.back().pose.position.y, 4.5, 1e-3);
}

TEST_F(Nodelet, AsksForItsMapWhereNoneIsPublished) {
  const boost::function<bool(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response&)> give =
      [](nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
        response.map = test::drawn(test::twoRoomsAndACloset());
        return true;
      };
  const ros::ServiceServer server = nh_.advertiseService("static_map", give);
  EXPECT_TRUE(eventually([this] {
    return ask<agrid_map::GetGraph>("asking/get_graph").status.code == int{Status::SUCCESS};
  }));
}

}  // namespace
}  // namespace agrid_map_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "agrid_nodelet_test");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
