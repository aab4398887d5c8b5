// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/conversions.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

std::uint8_t codeOf(agrid::PlanStatus status) {
  switch (status) {
    case agrid::PlanStatus::kSuccess:
      return agrid_map::Status::SUCCESS;
    case agrid::PlanStatus::kInvalidRequest:
      return agrid_map::Status::INVALID_REQUEST;
    case agrid::PlanStatus::kUnknownName:
      return agrid_map::Status::UNKNOWN_NAME;
    case agrid::PlanStatus::kStartInvalid:
      return agrid_map::Status::START_INVALID;
    case agrid::PlanStatus::kGoalInvalid:
      return agrid_map::Status::GOAL_INVALID;
    case agrid::PlanStatus::kNoRoute:
      return agrid_map::Status::NO_ROUTE;
    case agrid::PlanStatus::kTimeout:
      return agrid_map::Status::TIMEOUT;
    case agrid::PlanStatus::kCancelled:
      return agrid_map::Status::CANCELLED;
  }
  return agrid_map::Status::INVALID_REQUEST;
}

}  // namespace

agrid_map::Status statusOf(std::uint8_t code, const std::string& message) {
  agrid_map::Status status;
  status.code = code;
  status.message = message;
  return status;
}

agrid_map::Status statusOf(agrid::PlanStatus status, const std::string& message) {
  return statusOf(codeOf(status), printable(message));
}

agrid_map::Route toMsg(const agrid::Route& route, const agrid::AreaMap& areas) {
  agrid_map::Route msg;
  for (const std::size_t index : route.areas) {
    const agrid::Area& area = areas.areas.at(index);
    msg.areas.push_back(static_cast<std::uint32_t>(area.id));
    msg.names.push_back(area.name);
  }
  for (const std::size_t index : route.doors) {
    const agrid::DoorId id = index == agrid::kNoDoor ? agrid::DoorId{0} : areas.doors.at(index).id;
    msg.doors.push_back(static_cast<std::uint32_t>(id));
  }
  msg.length = route.length;
  return msg;
}

nav_msgs::Path pathToMsg(const std::vector<agrid::Pose2>& path_map,
                         const std_msgs::Header& header) {
  nav_msgs::Path msg;
  msg.header = header;
  for (const agrid::Pose2& pose : path_map) {
    msg.poses.emplace_back();
    msg.poses.back().header = header;
    msg.poses.back().pose = toMsg(pose);
  }
  return msg;
}

}  // namespace agrid_map_ros
