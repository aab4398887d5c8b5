// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag_proposal.h"
#include "tags/division.h"
#include "tags/relief.h"

namespace agrid {

/// A seed for each area that holds none of the area tags among `tags`. Its place is the highest
/// peak of the area, unless that is too narrow to be entered; with AreaMethod::kPaper it is the
/// pixel of a portion of the free space nearest to the portion's centroid (paper, 3.2: the centroid
/// itself lies outside portions that bend).
std::vector<AreaTag> proposeSeeds(const Relief& relief, const Division& division,
                                  const MapGeometry& geometry, const std::vector<Tag>& tags,
                                  const AreaParams& params);

}  // namespace agrid
