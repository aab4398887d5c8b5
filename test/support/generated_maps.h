// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "agrid/map/occupancy_map.h"

namespace agrid::test {

/// Free pixels among which each is occupied with the same probability; 0.05 m.
inline OccupancyGrid noise(unsigned seed, int width, int height, double density) {
  std::mt19937 random(seed);
  std::bernoulli_distribution occupied(density);
  OccupancyGrid grid;
  grid.geometry = {width, height, 0.05, Pose2{}};
  for (std::size_t i = 0; i < grid.geometry.pixelCount(); ++i) {
    grid.values.push_back(static_cast<std::int8_t>(occupied(random) ? 100 : 0));
  }
  return grid;
}

/// A map of one value; 0.05 m.
inline OccupancyGrid uniform(int width, int height, std::int8_t value) {
  OccupancyGrid grid;
  grid.geometry = {width, height, 0.05, Pose2{}};
  grid.values.assign(grid.geometry.pixelCount(), value);
  return grid;
}

}  // namespace agrid::test
