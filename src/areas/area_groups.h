// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "areas/automatic_areas.h"

namespace agrid {

/// How tags put automatic areas together and take them apart.
struct Grouping {
  std::vector<AreaGroup> groups;          ///< not parted yet, in order of their lowest members
  std::vector<std::size_t> group_of;      ///< for each automatic area
  std::vector<std::size_t> absent_doors;  ///< automatic doors that someone said are none, sorted
  std::vector<DoorTag> in_walls;          ///< given doors where no area is: shut ones, mostly
};

/// @param known  its areas and doors; pending ones are passed over
Grouping groupAreas(const OccupancyMap& map, const AutomaticAreas& automatic,
                    const Knowledge& known);

/// Label of an automatic area from its id.
std::uint16_t labelOf(const AutomaticAreas& automatic, AreaId id);

/// Whether two groups are parted the same way.
bool partedAlike(const AreaGroup& a, const AreaGroup& b);

}  // namespace agrid
