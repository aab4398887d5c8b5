// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag_proposal.h"
#include "tags/relief.h"

namespace agrid {

/// Finds the narrow passages of a map (paper, 3.2): where the distance from the walls has a saddle,
/// between walls that face each other across an axis of the image ('regularity'), have enough
/// obstacle points around ('number of points around them'), and the narrower of two that are close
/// to each other ('proximity').
/// @return from wall to wall, image frame in pixels, from the narrowest to the widest
std::vector<Segment> findNarrowPassages(const Relief& relief, const MapGeometry& geometry,
                                        const AreaParams& params);

}  // namespace agrid
