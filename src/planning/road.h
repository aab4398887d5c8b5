// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/fine_point.h"

namespace agrid::planning {

/// A corner of a road: a turning point, or a place on a portal's border where it need not bend.
struct RoadCorner {
  FinePoint at;
  std::int8_t blocked_x = 0;  ///< as in TurningPoint; 0 where it is none
  std::int8_t blocked_y = 0;
  /// The leg that leads here passes these of the road's regions.
  std::uint32_t first_region = 0;
  std::uint32_t last_region = 0;
};

/// A way over the roadmap: corners, each in sight of the next, and the regions passed.
struct Road {
  std::vector<RoadCorner> corners;     ///< the first is the start
  std::vector<std::uint32_t> regions;  ///< in order
  double length_bound_px = 0;          ///< no path is shorter
};

inline double lengthPx(const Road& road) {
  double length = 0;
  for (std::size_t i = 1; i < road.corners.size(); ++i) {
    length += distancePx(road.corners[i - 1].at, road.corners[i].at);
  }
  return length;
}

}  // namespace agrid::planning
