// SPDX-License-Identifier: BSD-3-Clause
#include "ros/map_intake.h"

#include <boost/make_shared.hpp>
#include <nav_msgs/GetMap.h>

#include "ros/boundary.h"

namespace agrid_map_ros {

MapIntake::MapIntake(ros::NodeHandle& nh, const Deps& deps) : deps_(deps) {
  static_map_ = nh.serviceClient<nav_msgs::GetMap>("static_map");
  map_subscriber_ = nh.subscribe("map", 1, &MapIntake::onMap, this);
  // patches build on each other, so none may be lost
  update_subscriber_ = nh.subscribe("map_updates", 100, &MapIntake::onUpdate, this);
  const auto parameters = deps_.settings.parameters();
  const double wait = (parameters ? *parameters : Parameters{}).node.static_map_wait;
  if (wait > 0) {
    static_map_timer_ =
        nh.createSteadyTimer(ros::WallDuration(wait), [this](const ros::SteadyTimerEvent&) {
          attempt(deps_.log, "static_map", [this] { askStaticMap(); });
        });
  }
}

MapIntake::~MapIntake() {
  static_map_timer_.stop();
  static_map_.shutdown();
  update_subscriber_.shutdown();
  map_subscriber_.shutdown();
}

void MapIntake::onMap(const nav_msgs::OccupancyGridConstPtr& map) {
  attempt(deps_.log, "map", [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    take(map, "map");
    warnOfPublishers();
  });
}

void MapIntake::warnOfPublishers() {
  if (map_subscriber_.getNumPublishers() > 1 && !warned_of_publishers_) {
    warned_of_publishers_ = true;
    deps_.log.warn("map", std::to_string(map_subscriber_.getNumPublishers()) +
                              " publishers on the map's topic; the last message wins");
  }
}

void MapIntake::take(const nav_msgs::OccupancyGridConstPtr& map, const std::string& source) {
  const auto parameters = deps_.settings.parameters();
  try {
    checkMap(*map, parameters ? parameters->map : agrid::MapParams{});
  } catch (const agrid::MapError& error) {
    return deps_.log.error(source, error.what());
  }
  latest_ = map;
  deps_.builder.offer(map);
}

void MapIntake::onUpdate(const map_msgs::OccupancyGridUpdateConstPtr& update) {
  attempt(deps_.log, "map_updates", [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    patch(*update);
  });
}

void MapIntake::patch(const map_msgs::OccupancyGridUpdate& update) {
  if (!latest_) return deps_.log.error("map_updates", "no map has arrived that could be patched");
  try {
    latest_ = boost::make_shared<const nav_msgs::OccupancyGrid>(patched(*latest_, update));
  } catch (const agrid::MapError& error) {
    return deps_.log.error("map_updates", error.what());
  }
  deps_.builder.offer(latest_);
}

void MapIntake::askStaticMap() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (latest_) return static_map_timer_.stop();
  }
  nav_msgs::GetMap service;
  if (!static_map_.exists() || !static_map_.call(service)) return warnOfNoMap();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (latest_) return;
  take(boost::make_shared<const nav_msgs::OccupancyGrid>(service.response.map), "static_map");
}

void MapIntake::warnOfNoMap() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (warned_of_no_map_ || latest_) return;
  warned_of_no_map_ = true;
  deps_.log.warn("map", "still waiting: no map on " + map_subscriber_.getTopic() +
                            " and none from the service " + static_map_.getService());
}

}  // namespace agrid_map_ros
