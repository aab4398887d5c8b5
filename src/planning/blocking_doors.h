// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/radius_level.h"

namespace agrid::planning {

/// Why two components are apart, for a person: the fewest doors, closed or too narrow for the
/// radius, that would have to let the robot through.
std::string explainNoRoute(const SemanticMap& map, const RadiusLevel& level,
                           std::uint32_t start_component, std::uint32_t goal_component);

}  // namespace agrid::planning
