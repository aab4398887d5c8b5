// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/road_search.h"

namespace agrid::planning {

/// Shortens a road to the shortest path that passes all obstacles on the same side: corners that it
/// need not bend at are replaced by the turning points inside the corner.
/// @return false if a corner could not be replaced, so that the road may be longer than that
bool pullTaut(const FreeSpace& free, const Roadmap& roadmap, Road& road);

}  // namespace agrid::planning
