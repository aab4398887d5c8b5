// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid::test {

/// A map from a drawing: '#' wall, '.' free, '?' unknown; the first row is the top (largest y).
inline OccupancyGrid asciiGrid(const std::vector<std::string>& rows, double resolution = 1,
                               const Pose2& map_from_image = {}) {
  OccupancyGrid grid;
  grid.geometry = {static_cast<int>(rows.at(0).size()), static_cast<int>(rows.size()), resolution,
                   map_from_image};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.values.push_back(static_cast<std::int8_t>(c == '#' ? 100 : c == '.' ? 0 : -1));
    }
  }
  return grid;
}

inline OccupancyMap asciiMap(const std::vector<std::string>& rows, double resolution = 1,
                             const Pose2& map_from_image = {}) {
  return OccupancyMap(asciiGrid(rows, resolution, map_from_image));
}

}  // namespace agrid::test
