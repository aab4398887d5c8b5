// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "planning/free_space.h"

namespace agrid::planning {

/// Shortens a path by OMPL's PathSimplifier in exactSpace(free).
/// @param path  each corner in sight of the next; stays so, and never becomes longer
void shortenByOmpl(const FreeSpace& free, std::uint32_t seed, std::vector<FinePoint>& path);

/// Whether OMPL finds every state and motion of the path valid in exactSpace(free).
bool passesOmplCheck(const FreeSpace& free, const std::vector<FinePoint>& path);

}  // namespace agrid::planning
