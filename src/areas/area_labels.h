// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag.h"
#include "tags/basins.h"
#include "tags/division.h"
#include "tags/relief.h"

namespace agrid {

/// Which area each pixel belongs to.
struct AreaLabels {
  static constexpr std::uint32_t kNone = Basins::kNone;
  std::vector<AreaTag> tags;  ///< what each area grew from, sorted by id, named
  /// Row-major: index into `tags`, or kNone. Clutter in an area is part of it, barriers too.
  std::vector<std::uint32_t> of_pixel;
  Openings openings;  ///< that the borders between areas may lie on
  std::vector<std::string> warnings;
};

/// Leaves out the areas without a free pixel on `map` and, beyond what a label can count, the
/// smallest.
/// @return for each former label the new one or AreaLabels::kNone; nothing if all stay
std::vector<std::uint32_t> dropAreas(const OccupancyMap& map, AreaLabels& labels);

/// Leaves out the areas whose new label is AreaLabels::kNone, see dropAreas.
void relabel(const std::vector<std::uint32_t>& new_label, AreaLabels& labels);

/// Grows an area from each usable area tag (paper, 3.2), with the doors of `relief` closed, then
/// opens the doors again: each pixel of a barrier goes to the area beside it.
/// @param division  of `relief`
/// @throws std::invalid_argument if two area tags have the same id
AreaLabels growAreas(const OccupancyMap& map, const Relief& relief, Division division,
                     const std::vector<Tag>& tags, const AreaParams& params);

}  // namespace agrid
