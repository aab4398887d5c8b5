// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planning/radius_level.h"

namespace agrid::planning {

/// Why two places are apart, for a person: the fewest doors, closed or too narrow for the radius,
/// that would have to let the robot through.
/// @param start  component of free space
/// @param goals  components, any of which will do
std::string explainNoRoute(const SemanticMap& map, const RadiusLevel& level,
                           const Obstacles& obstacles, std::uint32_t start,
                           const std::vector<std::uint32_t>& goals);

}  // namespace agrid::planning
