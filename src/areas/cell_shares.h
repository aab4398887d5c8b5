// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/areas/pixel_labels.h"
#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// How many pixels of a cell have a label.
struct CellShare {
  std::uint16_t label = 0;
  std::uint32_t pixels = 0;
};

/// How the labels share the cells of the A-Grid.
class CellShares {
 public:
  CellShares() = default;
  /// @param label_count  no label is greater
  CellShares(const AGrid& grid, const MapGeometry& geometry, const PixelLabels& labels,
             std::size_t label_count);

  /// Of a cell, by label; without those that have none.
  const CellShare* begin(std::size_t cell) const { return shares_.data() + first_[cell]; }
  const CellShare* end(std::size_t cell) const { return shares_.data() + first_[cell + 1]; }
  /// The cells that pixels with a label lie in, sorted.
  const std::vector<std::uint32_t>& cellsOf(std::uint16_t label) const {
    return cells_of_[label - 1U];
  }

 private:
  std::vector<CellShare> shares_;
  std::vector<std::uint32_t> first_;  ///< place of each cell's first share
  std::vector<std::vector<std::uint32_t>> cells_of_;
};

}  // namespace agrid
