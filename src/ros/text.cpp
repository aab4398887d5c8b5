// SPDX-License-Identifier: BSD-3-Clause
#include "ros/text.h"

#include <algorithm>
#include <locale>
#include <numeric>
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

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

std::vector<std::string> closestNames(const std::string& wanted,
                                      const std::vector<std::string>& names, std::size_t count) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    ranked.emplace_back(editDistance(lowerCase(wanted), lowerCase(name)), name);
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> closest;
  for (const auto& [distance, name] : ranked) {
    if (closest.size() == count) break;
    if (closest.empty() || closest.back() != name) closest.push_back(name);
  }
  return closest;
}

std::string lowerCase(const std::string& text) {
  std::string result = text;
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

}  // namespace agrid_map_ros
