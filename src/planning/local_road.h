// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/road_end.h"

namespace agrid::planning {

/// A path between two points of one region.
struct LocalRoad {
  float length = kUnreachable;           ///< [px]
  std::vector<RegionRoads::Node> nodes;  ///< the turning points on the way
};

/// The shortest one around the region's turning points (A*); the ends do not see each other.
LocalRoad findLocalRoad(RoadEnd& start, RoadEnd& goal);

}  // namespace agrid::planning
