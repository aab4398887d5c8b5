// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/costmap_frame.h"

#include <ros/console.h>

#include "agrid_map_ros/conversions.h"

namespace agrid_map_plugins {

agrid::MapGeometry geometryOf(const costmap_2d::Costmap2D& costmap) {
  agrid::MapGeometry geometry;
  geometry.width = static_cast<int>(costmap.getSizeInCellsX());
  geometry.height = static_cast<int>(costmap.getSizeInCellsY());
  geometry.resolution = costmap.getResolution();
  geometry.map_from_image.position = {costmap.getOriginX(), costmap.getOriginY()};
  return geometry;
}

std::optional<agrid::Pose2> frameFromMap(const tf2_ros::Buffer& transforms,
                                         const std::string& costmap_frame,
                                         const std::string& map_frame) {
  if (costmap_frame == map_frame) return agrid::Pose2{};
  try {
    const auto transform = transforms.lookupTransform(costmap_frame, map_frame, ros::Time(0));
    const geometry_msgs::Vector3& to = transform.transform.translation;
    return agrid::Pose2{{to.x, to.y}, agrid_map_ros::yawOf(transform.transform.rotation)};
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(10, "where the map is in the costmap's frame is not known: %s", error.what());
    return std::nullopt;
  }
}

}  // namespace agrid_map_plugins
