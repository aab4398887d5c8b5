// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// Gives each of some pixels to the region that is nearest over these pixels.
/// @param open  row-major indices; those that have a label keep it
/// @param labels  row-major, Basins::kNone = no region
void handOver(const std::vector<std::size_t>& open, const MapGeometry& geometry,
              std::vector<std::uint32_t>& labels);

}  // namespace agrid
