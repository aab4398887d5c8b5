// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/tags/tag_proposal.h"
#include "tags/region_graph.h"

namespace agrid {

/// Merges regions that people would not draw a border between (see separation), the surest first;
/// after each step what has changed is judged again. Then each region under min_area_size, or with
/// no place min_area_clearance from the walls, joins the neighbour that it is parted from the
/// least.
/// @return for each region the one that it belongs to
std::vector<std::uint32_t> mergeByBorders(RegionGraph graph, const AreaParams& params);

}  // namespace agrid
