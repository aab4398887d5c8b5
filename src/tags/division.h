// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/tags/tag_proposal.h"
#include "tags/basins.h"
#include "tags/openings.h"
#include "tags/relief.h"

namespace agrid {

/// A relief divided into areas.
struct Division {
  Basins basins;
  std::vector<std::uint32_t> area_of;  ///< for each basin, the highest basin of its area
  Openings openings;                   ///< that basins were cut at; none for kPersistence
};

/// Finds the basins of a relief and merges those that make one area. This is where to try another
/// idea of what an area is.
/// @return nothing for AreaMethod::kPaper, whose areas grow along the contours
Division divide(const Relief& relief, double resolution, const AreaParams& params);

}  // namespace agrid
