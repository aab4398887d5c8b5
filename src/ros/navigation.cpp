// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/navigation.h"

#include <algorithm>
#include <cmath>

#include "agrid/areas/area_cost.h"
#include "agrid_map_ros/conversions.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

agrid::Segment jambsOf(const agrid_map::Door& door, const agrid::Pose2& frame_from_map) {
  const agrid::Segment jambs = fromMsg(door).jambs_map;
  return {frame_from_map * jambs.a, frame_from_map * jambs.b};
}

std::string listed(const std::vector<agrid_map::Door>& doors) {
  std::string names = doors.size() == 1 ? "door " : "doors ";
  for (std::size_t i = 0; i < doors.size(); ++i) {
    names += (i > 0 ? ", '" : "'") + printable(doors[i].name) + "'";
  }
  return names;
}

std::string waysOf(const agrid::FollowedPath& path) {
  using Status = agrid::FollowedPath::Status;
  using Origin = agrid::FollowedPath::Origin;
  switch (path.status) {
    case Status::kStartOutside:
      return "the start is off the global costmap";
    case Status::kGoalOutside:
      return "the goal is off the global costmap";
    case Status::kGoalBlocked:
      return "the goal is in an obstacle of the costmap or too near to one";
    case Status::kNoWay:
      return "the costmap does not connect start and goal";
    case Status::kFound:
      break;
  }
  if (path.origin == Origin::kLead) return "along the lead";
  return path.origin == Origin::kOtherLead ? "through other doors" : "over the costmap alone";
}

}  // namespace

agrid::AreaCosts areaCosts(const agrid_map::TopologicalGraph& graph,
                           const agrid::Pose2& frame_from_map) {
  agrid::AreaCosts costs;
  for (const agrid_map::Area& msg : graph.areas) {
    agrid::Area area = fromMsg(msg);
    for (agrid::Point2& corner : area.outline_map) corner = frame_from_map * corner;
    costs.areas.push_back({area.outline_map, area.size, agrid::areaCost(area.properties)});
  }
  for (const agrid_map::Door& door : graph.doors) {
    if (door.state != agrid_map::Door::CLOSED) continue;
    costs.closed_doors.push_back(jambsOf(door, frame_from_map));
  }
  return costs;
}

agrid::Lead leadOf(const agrid_map::PlanPath::Response& response,
                   const agrid_map::TopologicalGraph& graph, const agrid::Pose2& frame_from_map) {
  agrid::Lead lead;
  lead.found = response.status.code == agrid_map::Status::SUCCESS;
  lead.message = response.status.message;
  for (const auto& pose : response.path.poses) {
    lead.path.push_back(frame_from_map * fromMsg(pose.pose).position);
  }
  std::vector<agrid::DoorId> ids;
  for (const std::uint32_t id : response.route.doors) ids.push_back(agrid::DoorId{id});
  for (const agrid_map::Door& door : doorsOf(graph, ids)) {
    lead.doors.push_back({agrid::DoorId{door.id}, jambsOf(door, frame_from_map)});
  }
  return lead;
}

std::vector<geometry_msgs::PoseStamped> posesOf(const std::vector<agrid::Point2>& path,
                                                const geometry_msgs::PoseStamped& goal) {
  std::vector<geometry_msgs::PoseStamped> poses;
  for (std::size_t i = 0; i < path.size(); ++i) {
    geometry_msgs::PoseStamped pose;
    pose.header = goal.header;
    agrid::Pose2 at{path[i], 0};
    if (i + 1 < path.size()) {
      const agrid::Point2 ahead = path[i + 1] - path[i];
      at.yaw = std::atan2(ahead.y(), ahead.x());
    }
    pose.pose = toMsg(at);
    pose.pose.position.z = goal.pose.position.z;
    poses.push_back(pose);
  }
  if (poses.empty()) return poses;
  poses.back().pose.orientation = goal.pose.orientation;
  const agrid::Point2 wanted(goal.pose.position.x, goal.pose.position.y);
  constexpr double kSamePlace = 1e-4;  // a path is rounded to fractions of a pixel [m]
  if ((path.back() - wanted).norm() < kSamePlace) poses.back().pose = goal.pose;
  return poses;
}

std::vector<agrid_map::Door> doorsOf(const agrid_map::TopologicalGraph& graph,
                                     const std::vector<agrid::DoorId>& ids) {
  std::vector<agrid_map::Door> doors;
  for (const agrid::DoorId id : ids) {
    const auto door =
        std::find_if(graph.doors.begin(), graph.doors.end(),
                     [&](const agrid_map::Door& d) { return agrid::DoorId{d.id} == id; });
    if (door != graph.doors.end()) doors.push_back(*door);
  }
  return doors;
}

std::string describe(const agrid::FollowedPath& path,
                     const std::vector<agrid_map::Door>& blocked_doors) {
  std::string text = waysOf(path);
  if (!blocked_doors.empty()) {
    text =
        listed(blocked_doors) + (blocked_doors.size() == 1 ? " is" : " are") + " blocked: " + text;
  }
  if (!path.lead_message.empty()) text += "; on the static map: " + printable(path.lead_message);
  return text;
}

}  // namespace agrid_map_ros
