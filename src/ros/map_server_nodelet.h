// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include <nav_msgs/GetMap.h>
#include <nav_msgs/LoadMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>

#include "ros/event_log.h"

namespace agrid_map_ros {

/// Offers what map_server offers (doc/map_files.md): topics `map` and `map_metadata`, latched;
/// services `static_map`, once there is a map, and `change_map`.
/// Loading it returns at once; the map is read on a thread of its own. A map that cannot be read
/// leaves the one before it in place.
///
/// Parameters, all texts, read when it is loaded:
/// - `~map_file`: the YAML file, path or file:// URL; none: it waits for change_map
/// - `~frame_id`: of the map (default "map")
/// - `~map_dir`: the folder under which all files must lie; change_map is refused where it is unset
class MapServerNodelet : public nodelet::Nodelet {
 public:
  ~MapServerNodelet() override;

 private:
  using MapPtr = nav_msgs::OccupancyGridConstPtr;

  void onInit() override;
  bool readParameters(ros::NodeHandle& private_nh);
  std::uint8_t load(const std::string& url, bool only_first);
  void show(const MapPtr& map);
  bool onStaticMap(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);
  bool onChangeMap(nav_msgs::LoadMap::Request& request, nav_msgs::LoadMap::Response& response);
  MapPtr current() const;

  std::string map_file_;
  std::string frame_id_ = "map";
  std::string map_dir_;
  bool parameters_are_good_ = false;
  EventLog log_;
  std::mutex load_mutex_;  // one map is read at a time
  mutable std::mutex map_mutex_;
  MapPtr map_;
  ros::NodeHandle nh_;
  ros::Publisher metadata_publisher_;
  ros::Publisher map_publisher_;
  ros::ServiceServer static_map_server_;
  ros::ServiceServer change_map_server_;
  std::thread first_load_;
};

}  // namespace agrid_map_ros
