// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid::bench {

/// What a robot sees from a place: all within reach, or what no obstacle hides.
enum class Seeing { kDisc, kLaser };

constexpr double kReach = 4;  ///< [m]

/// The map with new noise in each step: 5 % of the free pixels at obstacles and 0.02 % of the
/// others made occupied.
OccupancyGrid withNoise(const OccupancyGrid& grid, int step);

/// When each pixel of a map is first seen by a robot that starts at the free pixel farthest from
/// the middle and always goes to the nearest free pixel that it has not seen.
class Exploration {
 public:
  /// @param steps  in which free space is revealed, the same share of it each
  Exploration(const OccupancyMap& map, int steps, Seeing seeing);

  /// What was seen after a step, counted from 1, with noise, in the smallest frame of pixels that
  /// holds it.
  OccupancyGrid seen(int step) const;

 private:
  const OccupancyMap& map_;
  std::vector<std::uint32_t> stop_of_;    ///< at which it is first seen, row-major
  std::vector<std::uint32_t> last_stop_;  ///< of each step
};

}  // namespace agrid::bench
