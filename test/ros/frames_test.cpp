// SPDX-License-Identifier: BSD-3-Clause
#include "ros/frames.h"

#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

class FramesTest : public testing::Test {
 protected:
  /// child lies at (x, y), turned by yaw, in map
  void place(const std::string& child, double x, double y, double yaw) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    transform.transform.translation.y = y;
    transform.transform.rotation.z = std::sin(yaw / 2);
    transform.transform.rotation.w = std::cos(yaw / 2);
    buffer_.setTransform(transform, "test", true);
  }

  static geometry_msgs::PoseStamped pose(const std::string& frame, double x, double y, double yaw) {
    geometry_msgs::PoseStamped result;
    result.header.frame_id = frame;
    result.pose.position.x = x;
    result.pose.position.y = y;
    result.pose.orientation.z = std::sin(yaw / 2);
    result.pose.orientation.w = std::cos(yaw / 2);
    return result;
  }

  int codeOf(const geometry_msgs::PoseStamped& wanted) { return codeOf(frames_, wanted); }
  static int codeOf(const Frames& frames, const geometry_msgs::PoseStamped& wanted) {
    try {
      frames.planPoint(wanted);
    } catch (const RequestError& error) {
      return error.code();
    }
    return Status::SUCCESS;
  }

  tf2::BufferCore buffer_;
  std::atomic<bool> cancelled_{false};
  Frames frames_{buffer_, cancelled_, "map", 0.02};
};

TEST_F(FramesTest, T14_EmptyFrameIsTheMaps) {
  for (const char* frame : {"", "map", "/map"}) {
    const agrid::PlanPoint point = frames_.planPoint(pose(frame, 1, 2, 0.5));
    EXPECT_EQ(point.position_map, agrid::Point2(1, 2));
    EXPECT_NEAR(*point.yaw, 0.5, 1e-12);
  }
}

TEST_F(FramesTest, P8_AnotherFrameIsTransformed) {
  place("robot", 10, 20, M_PI / 2);
  for (const char* frame : {"robot", "/robot"}) {
    const agrid::PlanPoint point = frames_.planPoint(pose(frame, 1, 2, 0.5));
    EXPECT_NEAR(point.position_map.x(), 8, 1e-9);
    EXPECT_NEAR(point.position_map.y(), 21, 1e-9);
    EXPECT_NEAR(*point.yaw, 0.5 + M_PI / 2, 1e-9);
  }
}

TEST_F(FramesTest, P8_UnknownFrameIsNoTransformInTime) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(codeOf(pose("nowhere", 0, 0, 0)), int{Status::NO_TRANSFORM});
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(20));
}

TEST_F(FramesTest, P8_TimeWithoutTransformIsNoTransform) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.header.stamp = ros::Time(100);
  transform.child_frame_id = "robot";
  transform.transform.rotation.w = 1;
  buffer_.setTransform(transform, "test", false);
  auto wanted = pose("robot", 0, 0, 0);
  EXPECT_EQ(codeOf(wanted), int{Status::SUCCESS});  // a stamp of zero: the latest
  wanted.header.stamp = ros::Time(200);
  EXPECT_EQ(codeOf(wanted), int{Status::NO_TRANSFORM});
  wanted.header.stamp = ros::Time(50);
  EXPECT_EQ(codeOf(wanted), int{Status::NO_TRANSFORM});
}

TEST_F(FramesTest, P14_WaitingEndsWhenCancelled) {
  const Frames patient(buffer_, cancelled_, "map", 3600);
  std::thread canceller([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    cancelled_ = true;
  });
  EXPECT_EQ(codeOf(patient, pose("nowhere", 0, 0, 0)), int{Status::CANCELLED});
  canceller.join();
}

TEST_F(FramesTest, P10_WaitingEndsAtTheRequestsDeadline) {
  const Frames patient(buffer_, cancelled_, "map", 3600);
  const auto start = std::chrono::steady_clock::now();
  const Frames limited = patient.until(start + std::chrono::milliseconds(20));
  EXPECT_EQ(codeOf(limited, pose("nowhere", 0, 0, 0)), int{Status::NO_TRANSFORM});
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(20));
}

TEST_F(FramesTest, T14_FrameNameIsEscapedInTheMessage) {
  try {
    frames_.planPoint(pose("a\x1b[2Jb", 0, 0, 0));
    ADD_FAILURE();
  } catch (const RequestError& error) {
    EXPECT_EQ(std::string(error.what()).find('\x1b'), std::string::npos);
  }
}

TEST_F(FramesTest, ZeroQuaternionIsAnyHeading) {
  auto wanted = pose("map", 1, 2, 0);
  wanted.pose.orientation.w = 0;
  EXPECT_FALSE(frames_.planPoint(wanted).yaw);
  place("robot", 10, 20, M_PI / 2);
  wanted.header.frame_id = "robot";
  EXPECT_FALSE(frames_.planPoint(wanted).yaw);
}

TEST_F(FramesTest, T1_NumbersThatAreNone) {
  auto wanted = pose("map", std::nan(""), 0, 0);
  EXPECT_EQ(codeOf(wanted), int{Status::INVALID_REQUEST});
  EXPECT_EQ(codeOf(pose("map", 0, HUGE_VAL, 0)), int{Status::INVALID_REQUEST});
  wanted = pose("map", 0, 0, 0);
  wanted.pose.orientation.w = std::nan("");
  EXPECT_EQ(codeOf(wanted), int{Status::INVALID_REQUEST});
  wanted.pose.orientation.w = 1.1;
  EXPECT_EQ(codeOf(wanted), int{Status::INVALID_REQUEST});
}

TEST_F(FramesTest, RobotPose) {
  EXPECT_THROW(frames_.robotPose("base_link"), RequestError);
  place("base_link", 1, 2, 0.25);
  const agrid::Pose2 robot = frames_.robotPose("base_link");
  EXPECT_NEAR(robot.position.y(), 2, 1e-12);
  EXPECT_NEAR(robot.yaw, 0.25, 1e-12);
}

}  // namespace
}  // namespace agrid_map_ros
