// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <costmap_2d/costmap_2d.h>
#include <tf2_ros/buffer.h>

#include "agrid/map/map_geometry.h"

namespace agrid_map_plugins {

/// Where the pixels of a costmap lie in its frame.
agrid::MapGeometry geometryOf(const costmap_2d::Costmap2D& costmap);

/// The map's frame in a costmap's frame, as it is now; none, with a word in the log, if TF does not
/// know it.
std::optional<agrid::Pose2> frameFromMap(const tf2_ros::Buffer& transforms,
                                         const std::string& costmap_frame,
                                         const std::string& map_frame);

}  // namespace agrid_map_plugins
