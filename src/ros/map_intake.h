// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/service_client.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include "ros/event_log.h"
#include "ros/map_builder.h"
#include "ros/settings.h"

namespace agrid_map_ros {

/// Takes maps from the topic `map`, patches from `map_updates`, and where no map comes for a while
/// one from the service `static_map`; hands the newest one to the builder.
class MapIntake {
 public:
  struct Deps {
    const Settings& settings;
    MapBuilder& builder;
    EventLog& log;
  };
  MapIntake(ros::NodeHandle& nh, const Deps& deps);
  /// Waits for callbacks that are running.
  ~MapIntake();
  MapIntake(const MapIntake&) = delete;
  MapIntake& operator=(const MapIntake&) = delete;

 private:
  void onMap(const nav_msgs::OccupancyGridConstPtr& map);
  void onUpdate(const map_msgs::OccupancyGridUpdateConstPtr& update);
  void askStaticMap();
  /// Once, so that a map on another topic, or no map at all, can be found out.
  void warnOfNoMap();
  // for callers that hold the lock
  void warnOfPublishers();
  /// Hands a map on if its header and size are fine.
  void take(const nav_msgs::OccupancyGridConstPtr& map, const std::string& source);
  void patch(const map_msgs::OccupancyGridUpdate& update);

  Deps deps_;
  std::mutex mutex_;
  nav_msgs::OccupancyGridConstPtr latest_;  ///< the last one that patches can apply to
  bool warned_of_publishers_ = false;
  bool warned_of_no_map_ = false;
  ros::ServiceClient static_map_;
  ros::Subscriber map_subscriber_;
  ros::Subscriber update_subscriber_;
  ros::SteadyTimer static_map_timer_;
};

}  // namespace agrid_map_ros
