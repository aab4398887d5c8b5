// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/grid/a_grid.h"
#include "areas/area_groups.h"

namespace agrid {

/// The areas after all tags were laid, for what is said of their doors.
struct LaidAreas {
  const std::vector<Area>& areas;        ///< sorted by id
  const PixelLabels& pixel_labels;       ///< k = areas[k - 1]
  const std::vector<AreaGroup>& groups;  ///< with the areas of their parts
};

/// The doors between the areas, with what `known` says of them; its door tags become those of the
/// doors, automatic ones that mean no door are forgotten, and doors without one get a new one.
/// @return sorted by id
std::vector<Door> layDoors(const OccupancyMap& map, const AGrid& grid,
                           const AutomaticAreas& automatic, const Grouping& grouping,
                           const LaidAreas& areas, Knowledge& known);

}  // namespace agrid
