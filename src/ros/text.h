// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

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

/// The names joined by commas.
std::string joined(const std::vector<std::string>& names);

/// The fewest insertions, deletions and replacements of bytes that turn `a` into `b`.
std::size_t editDistance(const std::string& a, const std::string& b);
/// Up to `count` names nearest to `wanted` without regard to case, the nearest first.
std::vector<std::string> closestNames(const std::string& wanted,
                                      const std::vector<std::string>& names, std::size_t count = 3);

/// ASCII letters in lower case, everything else as it is.
std::string lowerCase(const std::string& text);

}  // namespace agrid_map_ros
