// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/tags/tag_proposal.h"
#include "tags/basins.h"
#include "tags/relief.h"

namespace agrid {

/// A relief divided into areas.
struct Division {
  Basins basins;
  std::vector<std::uint32_t> area_of;  ///< for each basin, the highest basin of its area
};

/// Finds the basins of a relief and merges those that make one area.
/// @return nothing for AreaMethod::kPaper, whose areas grow along the contours
Division divide(const Relief& relief, double resolution, const AreaParams& params);

}  // namespace agrid
