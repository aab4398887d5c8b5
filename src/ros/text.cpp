// SPDX-License-Identifier: BSD-3-Clause
#include "ros/text.h"

#include <locale>
#include <sstream>

namespace agrid_map_ros {

bool isPrintable(const std::string& text) { return agrid::printable(text) == text; }

std::string withoutLeadingSlash(const std::string& frame_id) {
  return !frame_id.empty() && frame_id.front() == '/' ? frame_id.substr(1) : frame_id;
}

std::string formatNumber(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

std::string formatQuaternion(const geometry_msgs::Quaternion& q) {
  return "(" + formatNumber(q.x) + ", " + formatNumber(q.y) + ", " + formatNumber(q.z) + ", " +
         formatNumber(q.w) + ")";
}

}  // namespace agrid_map_ros
