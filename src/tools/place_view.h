// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "agrid/semantic_map.h"

namespace agrid::tools {

/// How areas, doors and objects lie to each other.
struct PlaceView {
  struct DoorSides {
    DoorTag door;
    std::array<std::optional<AreaTag>, 2> areas;
  };

  Knowledge knowledge;           ///< that lies there
  std::vector<DoorSides> doors;  ///< those that are said to be absent are left out
  std::vector<AreaTag> seeds;    ///< what was to lie there
  std::vector<AreaId> at_seed;   ///< of each: the area that holds its seed, AreaId{0} if none does
  std::vector<ObjectTag> lost_objects;  ///< in no area
  std::vector<std::string> warnings;
};

/// By the outlines as last seen, the smallest one at a point. On either side of a door lies the
/// area nearest to its middle along its direction, within 0.6 m, that is not on the other side.
/// @param knowledge  all areas have an outline
PlaceView viewOfOutlines(const Knowledge& knowledge);

/// As the areas and doors are on the map.
/// @param laid  what was laid over it: of two areas with seeds in one, the map knows only one
PlaceView viewOfMap(const SemanticMap& map, const Knowledge& laid);

}  // namespace agrid::tools
