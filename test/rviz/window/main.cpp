// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "rviz_window.h"
#include "screen.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "agrid_rviz_window_test");
  const agrid_map_rviz::test::Screen screen;
  const QApplication application(argc, argv);
  agrid_map_rviz::test::RvizWindow::open();
  const int failed = RUN_ALL_TESTS();
  agrid_map_rviz::test::RvizWindow::close();
  return failed;
}
