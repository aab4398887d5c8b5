// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <agrid_map/GetGraph.h>
#include <agrid_map/LabelAt.h>
#include <agrid_map/PlanPath.h>

#include "agrid_map_ros/conversions.h"
#include "drawn_maps.h"

namespace agrid_map_ros::test {

/// Whether it becomes true within a time that is generous on any machine.
inline bool eventually(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

/// Talks to the nodelets of agrid_nodelet.test.
class NodeletClient : public testing::Test {
 protected:
  NodeletClient() {
    map_publisher_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    update_publisher_ = nh_.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 10);
  }

  template <typename Service>
  typename Service::Response ask(const std::string& name, typename Service::Request request = {}) {
    EXPECT_TRUE(ros::service::waitForService(name, ros::Duration(60))) << name;
    typename Service::Response response;
    EXPECT_TRUE(ros::service::call(name, request, response)) << name;
    return response;
  }

  agrid_map::TopologicalGraph graph() { return ask<agrid_map::GetGraph>("agrid/get_graph").graph; }

  static std::string digestOf(const nav_msgs::OccupancyGrid& map) {
    return agrid::OccupancyMap(fromMsg(map).grid).digest();
  }

  /// Publishes a map and waits until it is the one in use.
  void use(const nav_msgs::OccupancyGrid& map) {
    map_publisher_.publish(map);
    const std::string digest = digestOf(map);
    ASSERT_TRUE(eventually([&] {
      const auto now = graph();
      return now.map_id == digest && now.header.frame_id == map.header.frame_id;
    }));
  }
  void useTwoRooms() { use(drawn(twoRoomsAndACloset())); }

  static geometry_msgs::PoseStamped at(double x, double y, const std::string& frame = "") {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = frame;
    pose.pose.position.x = x;
    pose.pose.position.y = y;
    return pose;
  }

  agrid_map::PlanPath::Request pathRequest(double x = 9.5, double y = 3.5) {
    agrid_map::PlanPath::Request request;
    request.start = at(2.5, 3.5);
    request.goal = at(x, y);
    return request;
  }
  int pathStatus(const agrid_map::PlanPath::Request& request) {
    return ask<agrid_map::PlanPath>("agrid/plan_path", request).status.code;
  }
  std::uint32_t areaAt(double x, double y) {
    agrid_map::LabelAt::Request request;
    request.point.point.x = x;
    request.point.point.y = y;
    return ask<agrid_map::LabelAt>("agrid/label_at", request).area;
  }

  void placeRobot(double x, double y) { place("base_link", x, y); }
  void place(const std::string& frame, double x, double y, double yaw = 0) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = ros::Time::now();
    transform.header.frame_id = "map";
    transform.child_frame_id = frame;
    transform.transform.translation.x = x;
    transform.transform.translation.y = y;
    transform.transform.rotation.w = std::cos(yaw / 2);
    transform.transform.rotation.z = std::sin(yaw / 2);
    broadcaster_.sendTransform(transform);
  }

  /// A latched message of a topic.
  template <typename Message>
  typename Message::ConstPtr latched(const std::string& topic) {
    return ros::topic::waitForMessage<Message>(topic, nh_, ros::Duration(60));
  }

  ros::NodeHandle nh_;
  ros::Publisher map_publisher_;
  ros::Publisher update_publisher_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace agrid_map_ros::test
