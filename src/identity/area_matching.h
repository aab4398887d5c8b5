// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/identity/recognition.h"
#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// An area that was known, and may be one of those of the new map.
struct AreaClaim {
  AreaTag tag;
  bool waits = false;
};

/// Which area is which.
struct AreaMatches {
  std::vector<std::optional<std::size_t>> claim_of_area;  ///< by index of the area
  std::vector<std::optional<std::size_t>> area_of_claim;
  std::vector<std::string> doubt;  ///< by claim: why it has no area, a clause; empty if it has one
};

/// Each area is at most one of the claims. Claims with an outline are judged by what they have in
/// common with the areas, the others by their seed. Given claims beat automatic ones, those that
/// don't wait those that do.
AreaMatches matchAreas(const std::vector<AreaClaim>& claims, const AreaMap& fresh,
                       const MapGeometry& geometry, const RecognitionParams& params);

}  // namespace agrid
