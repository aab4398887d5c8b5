// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// How areas are found; lengths in metres.
enum class AreaMethod {
  kPersistence,  ///< watershed of the distance transform, merged by persistence
  kPaper         ///< narrow passages as doors, centroids as seeds, watershed, opening (paper, 3.2)
};

struct AreaParams {
  AreaMethod method = AreaMethod::kPersistence;
};

/// Finds area seeds and doors by geometry alone (paper, 3.2: automatic tagging), for the parts of
/// the map that `given` says nothing about.
std::vector<Tag> proposeTags(const OccupancyMap& map, const std::vector<Tag>& given,
                             const AreaParams& params = {});

}  // namespace agrid
