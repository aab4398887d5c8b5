// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "agrid/areas/area_segmentation.h"
#include "support/square_grid.h"

namespace agrid::test {

/// Areas of a map from given tags and those that are proposed for the rest, on cells of 1 m.
inline AreaMap segment(const OccupancyMap& map, std::vector<Tag> tags = {},
                       const AreaParams& params = {}) {
  for (Tag& tag : proposeTags(map, tags, params)) tags.push_back(std::move(tag));
  return segmentAreas(map, squareGrid(map.geometry(), 1), tags, params);
}

}  // namespace agrid::test
