// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// Where an area was.
struct FormerPlace {
  Polygon outline_map;
  bool waits = false;  ///< of a tag that waits: other areas may have taken its place
};

/// Pixels that former places and the areas of a new map have in common. Of the places that don't
/// wait each pixel belongs to the smallest that holds it, so that rooms within a ring of corridors
/// are not the corridor's; those that wait have all that is in their outline.
struct OutlineOverlap {
  struct Common {
    std::size_t area = 0;  ///< label of the new map
    std::int64_t pixels = 0;
  };

  /// @param labels  row-major: the areas of the new map, 0 = none; all of them at most `area_count`
  OutlineOverlap(const std::vector<FormerPlace>& places, const MapGeometry& geometry,
                 const std::vector<std::uint16_t>& labels, std::size_t area_count);

  std::vector<std::vector<Common>> of_place;  ///< sorted by area, without 0
  std::vector<std::int64_t> place_size;       ///< on the map, without what belongs to others [px]
  std::vector<double> visible;                ///< share of the outline that lies on the map
  // by label
  std::vector<std::int64_t> area_size;   ///< [px]
  std::vector<std::int64_t> known;       ///< of it in places that don't wait [px]
  std::vector<std::int64_t> ever_known;  ///< of it in any place [px]
};

}  // namespace agrid
