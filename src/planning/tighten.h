// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/free_space.h"

namespace agrid::planning {

/// Length of a path [px].
double lengthPx(const std::vector<FinePoint>& path);

/// Shortens a path like a pulled string: corners go where their neighbours see each other, the
/// others move towards the inside of the turn as far as both neighbours stay in sight.
/// @param path  each corner in sight of the next; stays so
void tighten(const FreeSpace& free, std::vector<FinePoint>& path);

}  // namespace agrid::planning
