// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_global_planner.h>
#include <pluginlib/class_loader.hpp>

#include <agrid_map/AddTag.h>
#include <agrid_map/BlockedDoors.h>
#include <agrid_map/SetDoor.h>

#include "ros/nodelet_client.h"

namespace agrid_map_ros {
namespace {

using test::eventually;

/// A costmap with the layer, a planner that uses it, and the nodelet, on two rooms with a door.
class Plugins : public test::NodeletClient {
 protected:
  Plugins() : loader_("nav_core", "nav_core::BaseGlobalPlanner") {
    useTwoRooms();
    geometry_msgs::TransformStamped robot;
    robot.header.frame_id = "map";
    robot.child_frame_id = "base_link";
    robot.transform.translation.x = 2.5;
    robot.transform.translation.y = 3.5;
    robot.transform.rotation.w = 1;
    transforms_.setTransform(robot, "test", true);
    transforms_.setUsingDedicatedThread(true);
    costmap_ = std::make_unique<costmap_2d::Costmap2DROS>("costmap", transforms_);
    planner_ = loader_.createUniqueInstance("agrid_map/AGridPlanner");
    planner_->initialize("AGridPlanner", costmap_.get());
  }

  int costAt(double x, double y) {
    costmap_2d::Costmap2D& map = *costmap_->getCostmap();
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*map.getMutex());
    unsigned column = 0, row = 0;
    return map.worldToMap(x, y, column, row) ? map.getCost(column, row) : -1;
  }
  bool becomes(double x, double y, int cost) {
    return eventually([&] { return costAt(x, y) == cost; });
  }

  std::vector<geometry_msgs::PoseStamped> planTo(double x, double y) {
    geometry_msgs::PoseStamped start = at(2.5, 3.5, "map");
    geometry_msgs::PoseStamped goal = at(x, y, "map");
    start.pose.orientation.w = goal.pose.orientation.w = 1;
    std::vector<geometry_msgs::PoseStamped> plan;
    planner_->makePlan(start, goal, plan);
    return plan;
  }

  void setDoor(std::uint8_t state) {
    agrid_map::SetDoor::Request request;
    request.door = graph().doors.at(0).name;
    request.state = state;
    EXPECT_EQ(ask<agrid_map::SetDoor>("agrid/set_door", request).status.code, 0);
  }

  /// Gives the right room a cost.
  void setCost(const std::string& cost) {
    agrid_map::AddTag::Request request;
    request.tag.type = agrid_map::Tag::AREA;
    request.tag.id = areaAt(9.5, 3.5);
    request.tag.source = agrid_map::Tag::MANUAL;
    request.tag.properties.resize(1);
    request.tag.properties[0].key = "cost";
    request.tag.properties[0].value = cost;
    const auto response = ask<agrid_map::AddTag>("agrid/add_tag", request);
    EXPECT_EQ(response.status.code, 0) << response.status.message;
  }

  tf2_ros::Buffer transforms_;
  std::unique_ptr<costmap_2d::Costmap2DROS> costmap_;
  pluginlib::ClassLoader<nav_core::BaseGlobalPlanner> loader_;
  pluginlib::UniquePtr<nav_core::BaseGlobalPlanner> planner_;
};

TEST_F(Plugins, FollowTagsAsTheyCome) {
  const agrid_map::Door door = graph().doors.at(0);
  const double x = (door.jambs[0].x + door.jambs[1].x) / 2;
  const double y = (door.jambs[0].y + door.jambs[1].y) / 2;
  ASSERT_TRUE(becomes(x, y, 0)) << costAt(x, y);
  ASSERT_TRUE(eventually([&] { return !planTo(9.5, 3.5).empty(); }));
  const auto plan = planTo(9.5, 3.5);
  EXPECT_NEAR(plan.front().pose.position.x, 2.5, 1e-3);
  EXPECT_EQ(plan.back().pose.position.x, 9.5);
  EXPECT_EQ(plan.back().header.frame_id, "map");

  setDoor(agrid_map::Door::CLOSED);
  EXPECT_TRUE(becomes(x, y, costmap_2d::LETHAL_OBSTACLE));
  EXPECT_TRUE(planTo(9.5, 3.5).empty());
  setDoor(agrid_map::Door::OPEN);
  EXPECT_TRUE(becomes(x, y, 0));
  EXPECT_TRUE(eventually([&] { return !planTo(9.5, 3.5).empty(); }));

  setCost("4");
  EXPECT_TRUE(becomes(9.5, 3.5, 50));
  EXPECT_FALSE(planTo(9.5, 3.5).empty());
  setCost("forbidden");
  EXPECT_TRUE(becomes(9.5, 3.5, costmap_2d::LETHAL_OBSTACLE));
  EXPECT_TRUE(planTo(9.5, 3.5).empty());
  setCost("1");
  EXPECT_TRUE(becomes(9.5, 3.5, 0));
}

TEST_F(Plugins, WhatOnlyTheCostmapKnowsIsSaidOfItsDoor) {
  ASSERT_TRUE(eventually([&] { return !planTo(9.5, 3.5).empty(); }));
  const agrid_map::Door door = graph().doors.at(0);
  std::vector<agrid_map::Door> blocked;
  const ros::Subscriber subscriber = nh_.subscribe<agrid_map::BlockedDoors>(
      ros::this_node::getName() + "/AGridPlanner/blocked_doors", 1,
      [&](const agrid_map::BlockedDoors::ConstPtr& message) { blocked = message->doors; });
  costmap_->stop();  // so that the wall stays
  {
    costmap_2d::Costmap2D& map = *costmap_->getCostmap();
    unsigned column = 0, row = 0;
    map.worldToMap(door.jambs[0].x, door.jambs[0].y, column, row);
    for (row = 0; row < map.getSizeInCellsY(); ++row) {
      map.setCost(column, row, costmap_2d::LETHAL_OBSTACLE);
    }
  }
  EXPECT_TRUE(planTo(9.5, 3.5).empty());
  // again, as the planner's graph may have come only now
  EXPECT_TRUE(eventually(
      [&] { return planTo(9.5, 3.5).empty() && blocked.size() == 1 && blocked[0].id == door.id; }));
}

}  // namespace
}  // namespace agrid_map_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "plugins_test");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
