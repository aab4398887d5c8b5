// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_global_planner.h>
#include <nav_msgs/GetPlan.h>
#include <tf2_ros/transform_listener.h>

#include "agrid/planning/costmap_areas.h"
#include "agrid/planning/lead_follower.h"
#include "plugins/nodelet_client.h"

namespace agrid_map_plugins {

/// The global planner for move_base: a lead by areas and doors from the nodelet, followed over the
/// global costmap. Says on `~NAME/blocked_doors` and in the log which doors are blocked.
///
/// Parameters (~NAME/...): doc/navigation.md.
class AGridPlanner : public nav_core::BaseGlobalPlanner {
 public:
  void initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) override;
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan) override;
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan, double& cost) override;

 private:
  using Pose = geometry_msgs::PoseStamped;

  void readParameters(const ros::NodeHandle& node);
  /// The costmap as it is, with what tags say.
  agrid::Costmap costmapNow(const agrid::Point2& robot);
  agrid::Lead askForLead(const Pose& start, const Pose& goal,
                         const std::vector<agrid::DoorId>& closed);
  void report(const agrid::FollowedPath& path, const std::vector<Pose>& plan);

  std::string name_;
  std::string frame_;
  costmap_2d::Costmap2DROS* costmap_ros_ = nullptr;
  std::mutex mutex_;
  std::unique_ptr<agrid::LeadFollower> follower_;
  std::unique_ptr<agrid::CurrentAreas> areas_;
  std::unique_ptr<NodeletClient> nodelet_;
  NodeletClient::GraphPtr graph_;  ///< of the request that is being answered
  std::optional<agrid::Pose2> frame_from_map_;
  double tolerance_ = 0;
  double lead_timeout_ = 1;
  double lead_tolerance_ = 0.5;
  double robot_radius_ = 0;              ///< of leads [m]; 0: the nodelet's parameter
  std::vector<std::uint32_t> reported_;  ///< doors that were said to be blocked
  ros::Publisher plan_publisher_;
  ros::Publisher blocked_publisher_;
  ros::ServiceServer service_;
  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;  ///< where the costmap is not in `map`
};

}  // namespace agrid_map_plugins
