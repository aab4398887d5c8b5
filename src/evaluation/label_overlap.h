// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Row-major like a map: 0 = none.
using Labels = std::vector<std::uint16_t>;

/// Rooms of at most so many pixels do not count (Bormann et al. 2016).
constexpr std::size_t kMinLabelPixels = 100;

/// @throws std::invalid_argument naming `field` if there is not a label for each pixel of the map
void checkSize(const char* field, const Labels& labels, const OccupancyMap& map);

/// Renumbers labels from 1 without gaps, those of at most `min_pixels` become 0.
Labels compact(Labels labels, std::size_t min_pixels);

/// The labels of free pixels, 0 on all others.
Labels onFreePixels(Labels labels, const OccupancyMap& map);

/// Pixels that areas and rooms have in common.
struct LabelOverlap {
  struct Common {
    std::size_t room = 0;
    double pixels = 0;
  };

  /// @param areas, rooms  numbered without gaps (see compact), of the same size
  LabelOverlap(const Labels& areas, const Labels& rooms);
  std::size_t areas() const { return area_size.size() - 1; }
  std::size_t rooms() const { return room_size.size() - 1; }

  std::vector<std::vector<Common>> of_area;  ///< by area: its rooms, in their order, without 0
  std::vector<double> area_size;             ///< by area, outside all rooms too [px]
  std::vector<double> room_size;             ///< by room, outside all areas too [px]
};

}  // namespace agrid
