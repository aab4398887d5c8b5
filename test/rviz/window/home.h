// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>

namespace agrid_map_rviz::test {

/// A home of 12 m x 8 m with six rooms, in unknown space; there are two ways from the kitchen to
/// the hall.
inline nav_msgs::OccupancyGrid home() {
  struct Box {
    double left, low, right, high;
  };
  constexpr Box kFree[] = {{0.2, 3.3, 11.8, 4.7},  // hall
                           {0.2, 4.9, 4.0, 7.8},   // kitchen
                           {4.2, 4.9, 11.8, 7.8},  // living room
                           {0.2, 0.2, 5.0, 3.1},   // bedroom
                           {5.2, 0.2, 7.5, 3.1},   // bath
                           {7.7, 0.2, 11.8, 3.1},  // office
                           {1.5, 4.7, 2.4, 4.9},  {4.0, 6.0, 4.2, 6.9}, {7.0, 4.7, 7.9, 4.9},
                           {2.5, 3.1, 3.4, 3.3},  {6.0, 3.1, 6.9, 3.3}, {9.0, 3.1, 9.9, 3.3}};
  constexpr double kMargin = 1.5;
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.info.resolution = 0.05F;
  map.info.width = 300;
  map.info.height = 220;
  map.info.origin.position.x = map.info.origin.position.y = -kMargin;
  map.info.origin.orientation.w = 1;
  for (std::uint32_t row = 0; row < map.info.height; ++row) {
    for (std::uint32_t column = 0; column < map.info.width; ++column) {
      const double x = (column + 0.5) * 0.05 - kMargin;
      const double y = (row + 0.5) * 0.05 - kMargin;
      std::int8_t value = 0 < x && x < 12 && 0 < y && y < 8 ? 100 : -1;
      for (const Box& box : kFree) {
        if (box.left < x && x < box.right && box.low < y && y < box.high) value = 0;
      }
      map.data.push_back(value);
    }
  }
  return map;
}

}  // namespace agrid_map_rviz::test
