// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// Values of a pixel of a costmap that mean more than "costs so much" (costmap_2d/cost_values.h).
constexpr std::uint8_t kNoInformation = 255;
constexpr std::uint8_t kLethal = 254;     ///< an obstacle
constexpr std::uint8_t kInscribed = 253;  ///< so near to one that the robot touches it

/// What the navigation stack knows of the robot's surroundings right now (costmap_2d): the static
/// map, what the sensors saw, and what was added to both. Its axes are those of its frame.
struct Costmap {
  MapGeometry geometry;             ///< in the costmap's frame, without yaw
  std::vector<std::uint8_t> costs;  ///< row-major, row 0 = smallest y
};

/// What a metre counts by the costmap, as global_planner weighs it.
struct CostRules {
  double neutral_cost = 50;   ///< of a pixel of cost 0, above 0
  double cost_factor = 3;     ///< by which a pixel's cost is multiplied, at least 0
  int lethal_cost = 253;      ///< pixels of that cost are not entered, nor those above [1..254]
  bool allow_unknown = true;  ///< pixels without information are entered, as the dearest ones
};

}  // namespace agrid
