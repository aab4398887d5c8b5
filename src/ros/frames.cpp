// SPDX-License-Identifier: BSD-3-Clause
#include "ros/frames.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <tf2/exceptions.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include "agrid_map_ros/conversions.h"
#include "ros/request_error.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

void requireFinite(const geometry_msgs::Point& position) {
  if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) return;
  throw RequestError(agrid_map::Status::INVALID_REQUEST,
                     "the position (" + formatNumber(position.x) + ", " + formatNumber(position.y) +
                         ", " + formatNumber(position.z) + ") is not finite");
}

geometry_msgs::Quaternion unitQuaternion(const geometry_msgs::Quaternion& q) {
  const auto unit = normalized(q);
  if (unit) return *unit;
  throw RequestError(agrid_map::Status::INVALID_REQUEST,
                     "the quaternion " + formatQuaternion(q) +
                         " is neither of norm 1 (at most 1e-3 off) nor all zero (any heading)");
}

}  // namespace

Frames::Frames(const tf2::BufferCore& transforms, const std::atomic<bool>& cancelled,
               std::string map_frame, double timeout_seconds)
    : transforms_(transforms),
      cancelled_(cancelled),
      map_frame_(std::move(map_frame)),
      timeout_seconds_(timeout_seconds) {}

Frames Frames::until(std::chrono::steady_clock::time_point deadline) const {
  Frames frames = *this;
  frames.deadline_ = deadline;
  return frames;
}

agrid::PlanPoint Frames::planPoint(const geometry_msgs::PoseStamped& pose) const {
  requireFinite(pose.pose.position);
  const bool any_heading = isZero(pose.pose.orientation);
  geometry_msgs::PoseStamped unit = pose;
  if (any_heading) {
    unit.pose.orientation.w = 1;
  } else {
    unit.pose.orientation = unitQuaternion(pose.pose.orientation);
  }
  const std::string frame = withoutLeadingSlash(pose.header.frame_id);
  if (!frame.empty() && frame != map_frame_) {
    tf2::doTransform(unit, unit, mapFrom(frame, pose.header.stamp));
  }
  const agrid::Pose2 pose_map = fromMsg(unit.pose);
  agrid::PlanPoint result;
  result.position_map = pose_map.position;
  if (!any_heading) result.yaw = pose_map.yaw;
  return result;
}

agrid::Point2 Frames::point(const geometry_msgs::PointStamped& point) const {
  geometry_msgs::PoseStamped pose;
  pose.header = point.header;
  pose.pose.position = point.point;
  return planPoint(pose).position_map;
}

agrid::Pose2 Frames::robotPose(const std::string& base_frame) const {
  const auto transform = mapFrom(withoutLeadingSlash(base_frame), ros::Time(0)).transform;
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.orientation = transform.rotation;
  return fromMsg(pose);
}

geometry_msgs::TransformStamped Frames::mapFrom(const std::string& frame,
                                                const ros::Time& stamp) const {
  // tf2_ros::Buffer waits by the ROS clock, which may stand still in simulation
  using Clock = std::chrono::steady_clock;
  const auto timeout =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_seconds_));
  const auto deadline = std::min(deadline_, Clock::now() + timeout);
  for (;;) {
    try {
      return transforms_.lookupTransform(map_frame_, frame, stamp);
    } catch (const tf2::TransformException& error) {
      if (cancelled_) {
        throw RequestError(agrid_map::Status::CANCELLED, "the node is shutting down");
      }
      if (Clock::now() >= deadline) {
        throw RequestError(agrid_map::Status::NO_TRANSFORM,
                           "frame '" + printable(frame.substr(0, 256)) +
                               "' cannot be brought to '" + map_frame_ +
                               "': " + printable(std::string(error.what()).substr(0, 512)));
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace agrid_map_ros
