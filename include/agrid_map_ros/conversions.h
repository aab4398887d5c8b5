// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Header.h>

#include <agrid_map/AGrid.h>
#include <agrid_map/Area.h>
#include <agrid_map/Door.h>
#include <agrid_map/Route.h>
#include <agrid_map/Status.h>
#include <agrid_map/Tag.h>
#include <agrid_map/TopologicalGraph.h>

#include "agrid/planning/planner.h"
#include "agrid/semantic_map.h"
#include "agrid/semantic_map/thing_lookup.h"

namespace agrid_map_ros {

// --- values of the core and basic messages ------------------------------------------------------

geometry_msgs::Point toMsg(const agrid::Point2& point);  ///< z = 0
geometry_msgs::Pose toMsg(const agrid::Pose2& pose);     ///< z = 0, turned about z
/// Position and heading of the x axis; the quaternion need not have norm 1 but must not be zero.
agrid::Pose2 fromMsg(const geometry_msgs::Pose& pose);

/// The heading of the x axis of a unit quaternion [rad].
double yawOf(const geometry_msgs::Quaternion& q);
/// The quaternion with norm 1; none if it holds NaN or its norm is off by more than 1e-3.
std::optional<geometry_msgs::Quaternion> normalized(const geometry_msgs::Quaternion& q);
/// Whether all four components are 0: nobody has set it.
bool isZero(const geometry_msgs::Quaternion& q);

// --- the metric map -----------------------------------------------------------------------------

/// A frame name without a leading slash.
/// @throws agrid::MapError (kFrame) if it is empty, longer than 256 bytes or holds a control
///         character
std::string checkedFrame(const std::string& frame_id);

/// Where the pixels of a map message lie. A quaternion of zeros is taken as identity.
/// @throws agrid::MapError if a side is 0 or too large, there are more than `max_pixels`, the
///         resolution lies outside [0.001, 10] m, the origin is not finite or beyond 1e6 m, the
///         quaternion's norm is off by more than 1e-3 or it tilts the map by more than 1e-3 rad
agrid::MapGeometry geometryFromMsg(const nav_msgs::MapMetaData& info, double max_pixels);

/// A map as it came over the wire, its header checked.
struct ReceivedMap {
  agrid::OccupancyGrid grid;
  std::string frame_id;
  std::vector<std::string> warnings;  ///< what was accepted but looks wrong, a sentence each
};

/// Checks header, geometry and size of a map message before anything is allocated, then copies it.
/// @throws agrid::MapError as checkedFrame and geometryFromMsg, or (kSize) if the data does not
///         have width x height values
ReceivedMap fromMsg(const nav_msgs::OccupancyGrid& map, const agrid::MapParams& params = {});
/// The checks of fromMsg alone.
void checkMap(const nav_msgs::OccupancyGrid& map, const agrid::MapParams& params);

/// The map with free pixels 0, occupied ones 100, unknown ones -1.
nav_msgs::OccupancyGrid toMsg(const agrid::OccupancyMap& map, const std_msgs::Header& header);

/// The map with a rectangle of it replaced.
/// @throws agrid::MapError if the rectangle is empty, does not lie in the map, or its size is not
///         that of the data (kSize), or its frame is not the map's (kFrame)
nav_msgs::OccupancyGrid patched(const nav_msgs::OccupancyGrid& map,
                                const map_msgs::OccupancyGridUpdate& update);

// --- grid, areas, doors, graph ------------------------------------------------------------------

/// What tells one result from another: header of all its messages, and its version.
struct Stamp {
  std_msgs::Header header;  ///< frame_id: the map's frame; stamp: time of computation
  std::uint32_t version = 0;
};

agrid_map::AGrid gridToMsg(const agrid::SemanticMap& map, const Stamp& stamp);
/// @throws std::invalid_argument if the edges do not make a grid
agrid::AGrid fromMsg(const agrid_map::AGrid& grid);

agrid_map::Area toMsg(const agrid::Area& area);
agrid::Area fromMsg(const agrid_map::Area& area);  ///< anchor_clearance is 0: not in the message
agrid_map::Door toMsg(const agrid::Door& door);
/// @throws std::invalid_argument if kind, state or source is none of the message's constants
agrid::Door fromMsg(const agrid_map::Door& door);

agrid_map::TopologicalGraph graphToMsg(const agrid::SemanticMap& map, const Stamp& stamp);

/// Areas by most: -1 where there is none, else 1 + id modulo 99, a colour class for RViz.
nav_msgs::OccupancyGrid areasToMsg(const agrid::SemanticMap& map, const std_msgs::Header& header);

/// Areas, doors and objects as the tags that would make them, as services return them.
agrid_map::Tag tagOf(const agrid::Area& area, const std_msgs::Header& header);
agrid_map::Tag tagOf(const agrid::Door& door, const std_msgs::Header& header);
agrid_map::Tag tagOf(const agrid::ObjectTag& object, const std_msgs::Header& header);
agrid_map::Tag tagOf(const agrid::Thing& thing, const std_msgs::Header& header);
/// What waits, in its own frame, with the reason as the property `pending`.
agrid_map::Tag tagOf(const agrid::PendingTag& pending, const std_msgs::Header& header);

// --- plans --------------------------------------------------------------------------------------

agrid_map::Status statusOf(std::uint8_t code, const std::string& message = {});
/// The message without control characters: names of things stand in it.
agrid_map::Status statusOf(agrid::PlanStatus status, const std::string& message);
agrid_map::Route toMsg(const agrid::Route& route, const agrid::AreaMap& areas);
nav_msgs::Path pathToMsg(const std::vector<agrid::Pose2>& path_map, const std_msgs::Header& header);

}  // namespace agrid_map_ros
