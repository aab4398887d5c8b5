// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/free_space.h"
#include "planning/portal.h"
#include "planning/stop.h"

namespace agrid::planning {

/// A convex corner of the pixels that are not free: the only places where a shortest path bends.
struct TurningPoint {
  FinePoint at;  ///< one step of the lattice beside the corner, in the free pixel opposite
  std::int8_t blocked_x = 0;  ///< -1 or 1: where the pixel lies that is not free, seen from `at`
  std::int8_t blocked_y = 0;

  /// The corner itself: where the limit of ever nearer paths bends, which is a little shorter.
  FinePoint corner() const { return {at.x + blocked_x, at.y + blocked_y}; }

  /// Whether the straight line through `at` and `other` passes the corner without entering it: a
  /// shortest path can bend here only if both of its legs do.
  bool isTangentTo(FinePoint other) const {
    const std::int64_t dx = (other.x - at.x) * blocked_x;
    const std::int64_t dy = (other.y - at.y) * blocked_y;
    return !(dx > 0 && dy > 0) && !(dx < 0 && dy < 0);
  }
};

/// All of them, row by row.
std::vector<TurningPoint> turningPoints(const FreeSpace& free, const StopCheck& stop);
/// Those in a box of pixels of the map, in the same order.
std::vector<TurningPoint> turningPoints(const FreeSpace& free, const PixelBox& box,
                                        const StopCheck& stop);

}  // namespace agrid::planning
