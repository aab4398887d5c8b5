// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/grid/a_grid.h"
#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// Grows the areas from their seeds, closed against each other at the doors (paper, 3.2), and
/// labels the cells of the grid.
/// @param tags  area seeds and doors, given and proposed (see proposeTags); objects are passed over
AreaMap segmentAreas(const OccupancyMap& map, const AGrid& grid, const std::vector<Tag>& tags,
                     const AreaParams& params = {});

/// Areas with the tags they grew from.
struct TaggedAreas {
  std::vector<Tag> tags;  ///< the given ones, then the proposed ones
  AreaMap area_map;
  std::vector<double> mean_clearances;  ///< of the areas' pixels, from what is not free [m]
};

/// The same areas as proposeTags and segmentAreas one after the other, in less time: what both
/// look at is made once.
/// @param given  what people and robots said
/// @throws std::invalid_argument if a parameter is out of range
TaggedAreas findAreas(const OccupancyMap& map, const AGrid& grid, const std::vector<Tag>& given,
                      const AreaParams& params = {});

}  // namespace agrid
