// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/tags/tag_proposal.h"
#include "tags/basins.h"

namespace agrid {

/// Which basins make one area, by the persistence of their peaks: two stay apart only where the way
/// between them is much narrower than both. This is where to try another idea of what an area is.
/// @return for each basin, the basin of its area that has the highest peak
std::vector<std::uint32_t> mergeByPersistence(const Basins& basins, double resolution,
                                              const AreaParams& params);

}  // namespace agrid
