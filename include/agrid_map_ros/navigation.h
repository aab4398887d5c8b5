// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>

#include <agrid_map/PlanPath.h>
#include <agrid_map/TopologicalGraph.h>

#include "agrid/geometry/pose2.h"
#include "agrid/planning/costmap_areas.h"
#include "agrid/planning/lead_follower.h"

namespace agrid_map_ros {

// What the plugins of the navigation stack do, without the stack.

/// What a graph's tags say about where to drive, in another frame.
/// @throws std::invalid_argument if the graph holds constants that are none
agrid::AreaCosts areaCosts(const agrid_map::TopologicalGraph& graph,
                           const agrid::Pose2& frame_from_map);

/// The lead that `~plan_path` has given, with the doors that it goes through, in another frame.
agrid::Lead leadOf(const agrid_map::PlanPath::Response& response,
                   const agrid_map::TopologicalGraph& graph, const agrid::Pose2& frame_from_map);

/// A path as move_base takes it: each pose heads for the next one, the last one as the goal does;
/// the goal's very pose if the path ends there.
std::vector<geometry_msgs::PoseStamped> posesOf(const std::vector<agrid::Point2>& path,
                                                const geometry_msgs::PoseStamped& goal);

/// The doors of a graph that have these ids, in their order.
std::vector<agrid_map::Door> doorsOf(const agrid_map::TopologicalGraph& graph,
                                     const std::vector<agrid::DoorId>& ids);

/// What came of following leads, as a sentence for a person, the names printable.
std::string describe(const agrid::FollowedPath& path,
                     const std::vector<agrid_map::Door>& blocked_doors);

}  // namespace agrid_map_ros
