// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "planning/portal_graph.h"

namespace agrid::planning {

/// The fewest areas that would have to be entered on a way, by their labels, in its order, each
/// once; none if no way leads from start to goal.
/// @param areas  pieces of free space as if no area were forbidden; its classes are labels
/// @param start  a node of it
std::vector<std::uint16_t> forbiddenBetween(const PortalGraph& areas, std::uint32_t start,
                                            const std::function<bool(std::uint32_t)>& isGoal,
                                            const std::function<bool(std::uint16_t)>& isForbidden);

}  // namespace agrid::planning
