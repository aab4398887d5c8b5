// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <geometry_msgs/Quaternion.h>

#include "map/printable.h"

namespace agrid_map_ros {

using agrid::printable;

/// Whether a text is UTF-8 without control characters.
bool isPrintable(const std::string& text);

/// ROS 1 frames once began with a slash; TF2 does not take it.
std::string withoutLeadingSlash(const std::string& frame_id);

/// A number with six significant digits, whatever the locale.
std::string formatNumber(double value);
std::string formatQuaternion(const geometry_msgs::Quaternion& q);

}  // namespace agrid_map_ros
