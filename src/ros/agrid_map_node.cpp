// SPDX-License-Identifier: BSD-3-Clause
// The nodelet agrid_map/AGridNodelet as a node of its own. SIGINT and SIGTERM let it end what it
// stores, and then end with 0.
#include <csignal>

#include <nodelet/loader.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "agrid");
  // roscpp does so for SIGINT only
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  nodelet::Loader loader;
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), "agrid_map/AGridNodelet", ros::names::getRemappings(),
                   arguments)) {
    return 1;
  }
  ros::spin();
  return 0;
}
