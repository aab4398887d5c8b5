// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <tf2/buffer_core.h>

#include "agrid/planning/planner.h"

namespace agrid_map_ros {

/// Brings what a request says in any frame to the map's.
class Frames {
 public:
  /// @param transforms, cancelled  must outlive this; waiting ends when `cancelled` becomes true
  Frames(const tf2::BufferCore& transforms, const std::atomic<bool>& cancelled,
         std::string map_frame, double timeout_seconds);

  /// The same, but nothing is waited for beyond a point in time.
  Frames until(std::chrono::steady_clock::time_point deadline) const;

  /// An empty frame is the map's, a stamp of zero the latest time, a quaternion of zeros any
  /// heading.
  /// @throws RequestError INVALID_REQUEST if a number is not finite or the quaternion's norm is off
  ///         by more than 1e-3; NO_TRANSFORM if the frame cannot be brought to the map's in time;
  ///         CANCELLED if waiting for it was ended
  agrid::PlanPoint planPoint(const geometry_msgs::PoseStamped& pose) const;
  agrid::Point2 point(const geometry_msgs::PointStamped& point) const;
  /// The latest pose of the robot's frame, map frame.
  /// @throws RequestError NO_TRANSFORM, CANCELLED
  agrid::Pose2 robotPose(const std::string& base_frame) const;

 private:
  geometry_msgs::TransformStamped mapFrom(const std::string& frame, const ros::Time& stamp) const;

  const tf2::BufferCore& transforms_;
  const std::atomic<bool>& cancelled_;
  std::string map_frame_;
  double timeout_seconds_;
  std::chrono::steady_clock::time_point deadline_ = std::chrono::steady_clock::time_point::max();
};

}  // namespace agrid_map_ros
