// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/types.hpp>

#include "agrid/areas/area_map.h"
#include "agrid/geometry/segment.h"
#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"
#include "areas/pixel_raster.h"

namespace agrid {

/// The area that has most of each cell's pixels; see AreaMap::cell_areas.
/// @param areas  sorted by id
std::vector<AreaId> labelCells(const AGrid& grid, const MapGeometry& geometry,
                               const PixelLabels& labels, const std::vector<Area>& areas);

/// The cells that a box of pixels may meet.
std::vector<std::size_t> cellsOf(const AGrid& grid, const MapGeometry& geometry,
                                 const cv::Rect& box);

/// Counts the labels in single cells.
class CellLabeller {
 public:
  CellLabeller(const AGrid& grid, const MapGeometry& geometry, const PixelLabels& pixel_labels)
      : grid_(grid), geometry_(geometry), labels_(pixel_labels), raster_(grid, geometry) {}

  /// The label that most pixels of a cell have (a tie: the lowest), 0 if none has any.
  std::uint16_t most(Cell cell) const;

 private:
  const AGrid& grid_;
  const MapGeometry& geometry_;
  const PixelLabels& labels_;
  PixelRaster raster_;
};

/// The cells that a segment passes through: row-major indices, sorted, each once.
std::vector<std::uint32_t> cellsOnSegment(const AGrid& grid, const Segment& segment_map);

}  // namespace agrid
