// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>

namespace agrid_map_ros::test {

/// A drawing at 1 m a letter ('#' wall, '.' free, '?' unknown; first row on top), 0.1 m a pixel.
inline nav_msgs::OccupancyGrid drawn(const std::vector<std::string>& rows,
                                     const std::string& frame = "map") {
  constexpr std::uint32_t kScale = 10;
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = frame;
  map.info.resolution = 0.1F;
  map.info.width = static_cast<std::uint32_t>(rows.at(0).size()) * kScale;
  map.info.height = static_cast<std::uint32_t>(rows.size()) * kScale;
  map.info.origin.orientation.w = 1;
  for (std::uint32_t y = 0; y < map.info.height; ++y) {
    for (std::uint32_t x = 0; x < map.info.width; ++x) {
      const char c = rows[rows.size() - 1 - y / kScale][x / kScale];
      map.data.push_back(static_cast<std::int8_t>(c == '#' ? 100 : c == '.' ? 0 : -1));
    }
  }
  return map;
}

/// Two rooms side by side, joined by a door in the middle; (2.5, 3.5) lies in the left one,
/// (9.5, 3.5) in the right one; the closet at the right, (14.5, 3.5), cannot be reached.
inline std::vector<std::string> twoRoomsAndACloset() {
  return {"#################",  //
          "#.....#.....#...#",  //
          "#.....#.....#...#",  //
          "#...........#...#",  //
          "#.....#.....#...#",  //
          "#.....#.....#...#",  //
          "#################"};
}

/// The same with the door walled up.
inline std::vector<std::string> walledUp() {
  std::vector<std::string> rows = twoRoomsAndACloset();
  rows[3][6] = '#';
  return rows;
}

}  // namespace agrid_map_ros::test
