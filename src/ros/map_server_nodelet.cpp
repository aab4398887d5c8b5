// SPDX-License-Identifier: BSD-3-Clause
#include "ros/map_server_nodelet.h"

#include <exception>

#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "agrid_map_ros/conversions.h"
#include "agrid_map_ros/map_server.h"
#include "ros/boundary.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using Results = nav_msgs::LoadMap::Response;

// False if the parameter is there but no text; NodeHandle::param would take the default silently.
bool readText(ros::NodeHandle& private_nh, const std::string& name, std::string& text) {
  return !private_nh.hasParam(name) || private_nh.getParam(name, text);
}

}  // namespace

MapServerNodelet::~MapServerNodelet() {
  change_map_server_.shutdown();
  if (first_load_.joinable()) first_load_.join();
  static_map_server_.shutdown();
}

void MapServerNodelet::onInit() {
  nh_ = getMTNodeHandle();
  parameters_are_good_ = readParameters(getMTPrivateNodeHandle());
  metadata_publisher_ = nh_.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true);
  map_publisher_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  change_map_server_ = nh_.advertiseService("change_map", &MapServerNodelet::onChangeMap, this);
  if (!parameters_are_good_) return;
  if (map_file_.empty()) {
    log_.warn("map", "~map_file is not set: there is no map until change_map is called");
    return;
  }
  first_load_ = std::thread([this] { load(map_file_, true); });
}

bool MapServerNodelet::readParameters(ros::NodeHandle& private_nh) {
  bool good = true;
  const auto read = [&](const std::string& name, std::string& text) {
    if (readText(private_nh, name, text)) return;
    log_.error("parameter " + name, "~" + name + " must be a text");
    good = false;
  };
  read("map_file", map_file_);
  read("frame_id", frame_id_);
  read("map_dir", map_dir_);
  try {
    frame_id_ = checkedFrame(frame_id_);
  } catch (const std::invalid_argument& error) {
    log_.error("parameter frame_id", std::string("~frame_id: ") + error.what());
    good = false;
  }
  return good;
}

std::uint8_t MapServerNodelet::load(const std::string& url, bool only_first) {
  try {
    const std::lock_guard<std::mutex> one_at_a_time(load_mutex_);
    if (only_first && current()) return Results::RESULT_SUCCESS;  // change_map was faster
    agrid::MapFileParams params;
    params.map_dir = map_dir_;
    agrid::LoadedMap loaded = agrid::loadMap(pathOfUrl(url), params);
    for (const std::string& warning : loaded.warnings) ROS_WARN("%s", warning.c_str());
    auto map =
        boost::make_shared<nav_msgs::OccupancyGrid>(mapServerMessage(std::move(loaded), frame_id_));
    map->info.map_load_time = ros::Time::now();
    map->header.stamp = ros::Time::now();
    show(map);
    return Results::RESULT_SUCCESS;
  } catch (const agrid::FileError& error) {
    log_.error("map", error.what());
    return loadMapResult(error.code());
  } catch (...) {
    log_.error("map", "the map cannot be loaded: " + caught(log_, "map").message);
    return Results::RESULT_UNDEFINED_FAILURE;
  }
}

void MapServerNodelet::show(const MapPtr& map) {
  ROS_INFO("Read a map of %u x %u pixels of %.3f m", map->info.width, map->info.height,
           static_cast<double>(map->info.resolution));
  {
    const std::lock_guard<std::mutex> lock(map_mutex_);
    map_ = map;
  }
  metadata_publisher_.publish(map->info);
  map_publisher_.publish(map);
  // Not before: who waits for the service would be given an empty map.
  if (!static_map_server_) {
    static_map_server_ = nh_.advertiseService("static_map", &MapServerNodelet::onStaticMap, this);
  }
}

MapServerNodelet::MapPtr MapServerNodelet::current() const {
  const std::lock_guard<std::mutex> lock(map_mutex_);
  return map_;
}

bool MapServerNodelet::onStaticMap(nav_msgs::GetMap::Request&,
                                   nav_msgs::GetMap::Response& response) {
  response.map = *current();
  return true;
}

bool MapServerNodelet::onChangeMap(nav_msgs::LoadMap::Request& request,
                                   nav_msgs::LoadMap::Response& response) {
  if (!parameters_are_good_ || map_dir_.empty()) {
    log_.error("change_map", parameters_are_good_ ? "change_map is refused: ~map_dir is not set"
                                                  : "change_map is refused: bad parameters");
    response.result = Results::RESULT_UNDEFINED_FAILURE;
    return true;
  }
  response.result = load(request.map_url, false);
  if (response.result == Results::RESULT_SUCCESS) response.map = *current();
  return true;
}

}  // namespace agrid_map_ros

PLUGINLIB_EXPORT_CLASS(agrid_map_ros::MapServerNodelet, nodelet::Nodelet)
