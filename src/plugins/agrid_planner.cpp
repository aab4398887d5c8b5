// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/agrid_planner.h"

#include <algorithm>
#include <exception>

#include <nav_msgs/Path.h>
#include <pluginlib/class_list_macros.hpp>

#include <agrid_map/BlockedDoors.h>

#include "agrid_map_ros/navigation.h"
#include "plugins/costmap_frame.h"

PLUGINLIB_EXPORT_CLASS(agrid_map_plugins::AGridPlanner, nav_core::BaseGlobalPlanner)

namespace agrid_map_plugins {
namespace {

agrid::Point2 pointOf(const geometry_msgs::PoseStamped& pose) {
  return {pose.pose.position.x, pose.pose.position.y};
}

}  // namespace

void AGridPlanner::initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) {
  if (costmap_ros_ != nullptr) {
    ROS_WARN("%s was initialized before", name.c_str());
    return;
  }
  name_ = name;
  costmap_ros_ = costmap_ros;
  frame_ = costmap_ros->getGlobalFrameID();
  ros::NodeHandle node("~/" + name);
  readParameters(node);
  nodelet_ = std::make_unique<NodeletClient>(node.param<std::string>("nodelet", "agrid"));
  plan_publisher_ = node.advertise<nav_msgs::Path>("plan", 1);
  blocked_publisher_ = node.advertise<agrid_map::BlockedDoors>("blocked_doors", 1, true);
  using Request = nav_msgs::GetPlan::Request;
  using Response = nav_msgs::GetPlan::Response;
  service_ = node.advertiseService<Request, Response>(
      "make_plan", [this](Request& request, Response& response) {
        makePlan(request.start, request.goal, response.plan.poses);
        response.plan.header.stamp = ros::Time::now();
        response.plan.header.frame_id = frame_;
        return true;
      });
}

void AGridPlanner::readParameters(const ros::NodeHandle& node) {
  agrid::FollowParams params;
  agrid::CostRules& rules = params.rules;
  rules.neutral_cost = node.param("neutral_cost", rules.neutral_cost);
  rules.cost_factor = node.param("cost_factor", rules.cost_factor);
  rules.lethal_cost = node.param("lethal_cost", rules.lethal_cost);
  rules.allow_unknown = node.param("allow_unknown", rules.allow_unknown);
  params.band = node.param("band", params.band);
  params.detour = node.param("detour", params.detour);
  params.max_leads = node.param("max_leads", params.max_leads);
  const std::string problem = agrid::problemOf(params);
  if (!problem.empty()) {
    ROS_ERROR("%s: %s; the defaults are used", name_.c_str(), problem.c_str());
    params = {};
  }
  tolerance_ = std::clamp(node.param("default_tolerance", tolerance_), 0.0, 10.0);
  lead_timeout_ = std::clamp(node.param("lead_timeout", lead_timeout_), 0.01, 60.0);
  lead_tolerance_ = std::clamp(node.param("lead_tolerance", lead_tolerance_), 0.0, 10.0);
  robot_radius_ = std::max(0.0, node.param("robot_radius", robot_radius_));
  follower_ = std::make_unique<agrid::LeadFollower>(params);
  areas_ = std::make_unique<agrid::CurrentAreas>(params.rules);
}

agrid::Costmap AGridPlanner::costmapNow(const agrid::Point2& robot) {
  costmap_2d::Costmap2D& shared = *costmap_ros_->getCostmap();
  agrid::Costmap costmap;
  {
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*shared.getMutex());
    costmap.geometry = geometryOf(shared);
    const unsigned char* costs = shared.getCharMap();
    costmap.costs.assign(costs, costs + costmap.geometry.pixelCount());
  }
  if (graph_ && frame_from_map_) {
    const agrid::AreaCosts areas = agrid_map_ros::areaCosts(*graph_, *frame_from_map_);
    const double radius = costmap_ros_->getLayeredCostmap()->getInscribedRadius();
    areas_->get(agrid::leavable(areas, robot, radius), costmap.geometry).raise(costmap);
  }
  return costmap;
}

agrid::Lead AGridPlanner::askForLead(const Pose& start, const Pose& goal,
                                     const std::vector<agrid::DoorId>& closed) {
  agrid::Lead none;
  none.message = "areas and doors are not known yet";
  if (!graph_ || !frame_from_map_) return none;
  agrid_map::PlanPath::Request request;
  request.start = start;
  request.goal = goal;
  request.start.header.stamp = request.goal.header.stamp = ros::Time(0);
  // any heading will do: this robot turns on the spot
  request.start.pose.orientation = request.goal.pose.orientation = geometry_msgs::Quaternion();
  request.tolerance = lead_tolerance_;
  request.robot_radius = robot_radius_;
  request.timeout = lead_timeout_;
  for (const agrid::DoorId id : closed) {
    request.closed_doors.push_back(static_cast<std::uint32_t>(id));
  }
  const auto response = nodelet_->plan(request, 1.5 * lead_timeout_);
  none.message = "the map's nodelet does not answer";
  return response ? agrid_map_ros::leadOf(*response, *graph_, *frame_from_map_) : none;
}

bool AGridPlanner::makePlan(const Pose& start, const Pose& goal, std::vector<Pose>& plan) {
  double cost = 0;
  return makePlan(start, goal, plan, cost);
}

bool AGridPlanner::makePlan(const Pose& start, const Pose& goal, std::vector<Pose>& plan,
                            double& cost) {
  const std::lock_guard<std::mutex> lock(mutex_);
  plan.clear();
  if (costmap_ros_ == nullptr) {
    ROS_ERROR("the planner must be initialized before it is used");
    return false;
  }
  for (const Pose* pose : {&start, &goal}) {
    if (pose->header.frame_id == frame_) continue;
    ROS_ERROR("%s: start and goal must be in the frame '%s', not in '%s'", name_.c_str(),
              frame_.c_str(), pose->header.frame_id.c_str());
    return false;
  }
  try {
    graph_ = nodelet_->graph();
    if (graph_ && graph_->header.frame_id != frame_ && !listener_) {
      listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_);
    }
    frame_from_map_ =
        graph_ ? frameFromMap(transforms_, frame_, graph_->header.frame_id) : std::nullopt;
    const agrid::FollowedPath path = follower_->plan(
        costmapNow(pointOf(start)), {pointOf(start), pointOf(goal)}, tolerance_,
        [&](const std::vector<agrid::DoorId>& closed) { return askForLead(start, goal, closed); });
    plan = agrid_map_ros::posesOf(path.path, goal);
    for (Pose& pose : plan) pose.header.stamp = ros::Time::now();
    cost = path.cost;
    report(path, plan);
  } catch (const std::exception& error) {
    ROS_ERROR("%s: %s", name_.c_str(), error.what());
    plan.clear();
  }
  return !plan.empty();
}

void AGridPlanner::report(const agrid::FollowedPath& path, const std::vector<Pose>& plan) {
  agrid_map::BlockedDoors blocked;
  blocked.header.stamp = ros::Time::now();
  blocked.header.frame_id = graph_ ? graph_->header.frame_id : frame_;
  if (graph_) blocked.doors = agrid_map_ros::doorsOf(*graph_, path.blocked_doors);
  std::vector<std::uint32_t> ids;
  for (const agrid_map::Door& door : blocked.doors) ids.push_back(door.id);
  const std::string text = agrid_map_ros::describe(path, blocked.doors);
  if (plan.empty()) {
    ROS_WARN_THROTTLE(1, "%s: no plan: %s", name_.c_str(), text.c_str());
  } else if (ids != reported_ && !ids.empty()) {
    ROS_WARN("%s: %s", name_.c_str(), text.c_str());
  } else if (!path.lead_message.empty()) {
    ROS_WARN_THROTTLE(10, "%s: %s", name_.c_str(), text.c_str());
  }
  if (ids != reported_) blocked_publisher_.publish(blocked);
  reported_ = ids;
  nav_msgs::Path message;
  message.header.stamp = blocked.header.stamp;
  message.header.frame_id = frame_;
  message.poses = plan;
  plan_publisher_.publish(message);
}

}  // namespace agrid_map_plugins
