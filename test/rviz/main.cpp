// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>

#include <gtest/gtest.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "agrid_rviz_test");
  const ros::NodeHandle node;  // ROS lives as long as the program
  const QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
