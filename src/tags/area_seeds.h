// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag_proposal.h"
#include "tags/relief.h"

namespace agrid {

/// The highest peak of each area by mergeByPersistence, without those that hold a pixel of `given`
/// and those too narrow to be entered.
std::vector<Pixel> findPeaks(const Relief& relief, const std::vector<Pixel>& given,
                             double resolution, const AreaParams& params);

/// For each portion of the free space that the contours close, its pixel nearest to its centroid
/// (paper, 3.2), without those that hold a pixel of `given`. The paper takes the centroid itself,
/// which lies outside its portion in corridors that bend.
std::vector<Pixel> findCentroids(const Relief& relief, const std::vector<Pixel>& given);

}  // namespace agrid
