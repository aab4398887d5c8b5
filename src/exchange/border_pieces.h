// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// A straight piece of the border between two areas that people drew.
struct BorderPiece {
  Segment line_map;  ///< [m]
  /// Pixels beyond it on either side, up to half a metre away, in the areas that it parts.
  std::vector<std::array<std::size_t, 2>> beside;
};

/// The borders between areas that lie at most a metre apart, as painted borders do.
/// @param labels  row-major like the map: 0 = no area
std::vector<BorderPiece> findBorderPieces(const OccupancyMap& map,
                                          const std::vector<std::uint16_t>& labels);

}  // namespace agrid
