// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "tags/basins.h"

namespace agrid {

/// Grows areas from their seeds over the basins of a relief. What belongs together by `area_of` is
/// flooded first, the rest joins the area that it opens to the widest; two seeds never end up in
/// one area. Where two lie in one basin, each pixel goes to the nearer one by path.
/// @param area_of  see mergeByPersistence
/// @param seeds  pixels of the relief, all different
/// @return row-major: the number of the seed each pixel belongs to, or Basins::kNone
std::vector<std::uint32_t> floodFromSeeds(Basins basins, const std::vector<std::uint32_t>& area_of,
                                          const std::vector<std::size_t>& seeds, int columns);

}  // namespace agrid
