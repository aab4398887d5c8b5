// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/area_layer.h"

#include <algorithm>
#include <exception>

#include <pluginlib/class_list_macros.hpp>

#include "agrid_map_ros/navigation.h"
#include "plugins/costmap_frame.h"

PLUGINLIB_EXPORT_CLASS(agrid_map_plugins::AreaLayer, costmap_2d::Layer)

namespace agrid_map_plugins {

AreaLayer::AreaLayer() {
  enabled_ = true;
  current_ = false;
}

void AreaLayer::onInitialize() {
  const ros::NodeHandle node("~/" + name_);
  agrid::FollowParams params;
  params.rules.neutral_cost = node.param("neutral_cost", params.rules.neutral_cost);
  params.rules.cost_factor = node.param("cost_factor", params.rules.cost_factor);
  const std::string problem = agrid::problemOf(params);
  if (!problem.empty()) {
    ROS_ERROR("%s: %s; the defaults are used", name_.c_str(), problem.c_str());
    params = {};
  }
  require_graph_ = node.param("require_graph", true);
  areas_ = std::make_unique<agrid::CurrentAreas>(params.rules);
  nodelet_ = std::make_unique<NodeletClient>(node.param<std::string>("nodelet", "agrid"));
  using Config = costmap_2d::GenericPluginConfig;
  switch_ = std::make_unique<dynamic_reconfigure::Server<Config>>(node);
  switch_->setCallback([this](Config& config, std::uint32_t /*level*/) {
    enabled_ = config.enabled;
    drawn_.reset();
  });
}

std::optional<agrid::AreaCosts> AreaLayer::areasNow(const agrid::Point2& robot) const {
  const NodeletClient::GraphPtr graph = nodelet_->graph();
  if (!graph) return std::nullopt;
  const auto pose =
      frameFromMap(*tf_, layered_costmap_->getGlobalFrameID(), graph->header.frame_id);
  if (!pose) return std::nullopt;
  try {
    return agrid::leavable(agrid_map_ros::areaCosts(*graph, *pose), robot,
                           layered_costmap_->getInscribedRadius());
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(10, "%s: %s", name_.c_str(), error.what());
    return std::nullopt;
  }
}

void AreaLayer::updateBounds(double robot_x, double robot_y, double /*robot_yaw*/, double* min_x,
                             double* min_y, double* max_x, double* max_y) {
  const auto now = areasNow({robot_x, robot_y});
  current_ = now || drawn_ || !require_graph_;
  if (!current_) {
    ROS_WARN_THROTTLE(10, "%s: waits for the graph of areas and doors", name_.c_str());
  }
  if (!now) return;
  if (drawn_ && *drawn_ == *now && !layered_costmap_->isRolling()) return;
  drawn_ = now;
  const costmap_2d::Costmap2D& master = *layered_costmap_->getCostmap();
  *min_x = std::min(*min_x, master.getOriginX());
  *min_y = std::min(*min_y, master.getOriginY());
  *max_x = std::max(*max_x, master.getOriginX() + master.getSizeInMetersX());
  *max_y = std::max(*max_y, master.getOriginY() + master.getSizeInMetersY());
}

void AreaLayer::updateCosts(costmap_2d::Costmap2D& master, int min_i, int min_j, int max_i,
                            int max_j) {
  if (!drawn_) return;
  areas_->get(*drawn_, geometryOf(master))
      .raise(master.getCharMap(), {min_i, min_j}, {max_i, max_j});
}

}  // namespace agrid_map_plugins
