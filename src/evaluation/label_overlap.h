// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "evaluation/assignment.h"

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

/// Pixels that each area (row) and each room (column) have in common; row and column 0: none.
struct LabelOverlap {
  LabelOverlap(const Labels& areas, const Labels& rooms);
  std::size_t areas() const { return counts.rows - 1; }
  std::size_t rooms() const { return counts.columns - 1; }

  CostMatrix counts;
  std::vector<double> area_size;
  std::vector<double> room_size;
};

}  // namespace agrid
