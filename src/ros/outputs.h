// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ros/snapshot.h"

namespace agrid_map_ros {

/// The latched topics ~agrid, ~graph, ~markers, ~areas and ~plan. Safe to use from several threads.
class Outputs {
 public:
  explicit Outputs(ros::NodeHandle& private_nh);

  void publish(const Snapshot& snapshot);
  void publishPlan(const nav_msgs::Path& path);

 private:
  ros::Publisher agrid_;
  ros::Publisher graph_;
  ros::Publisher markers_;
  ros::Publisher areas_;
  ros::Publisher plan_;
};

}  // namespace agrid_map_ros
