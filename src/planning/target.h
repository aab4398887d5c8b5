// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planning/portal_graph.h"

namespace agrid::planning {

/// Where a path ends: at one point, or at any pixel of an area.
struct Target {
  std::optional<FinePoint> point;
  std::uint16_t label = 0;             ///< without a point: of the area
  PixelBox box;                        ///< of the target's pixels
  std::vector<std::uint32_t> regions;  ///< with pixels of the target that the start reaches, sorted

  /// No way from there to the target is shorter [px].
  double distanceFrom(FinePoint p) const;
};

}  // namespace agrid::planning
