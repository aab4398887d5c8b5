// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/types.hpp>

#include "agrid/areas/area_map.h"
#include "agrid/geometry/segment.h"
#include "agrid/grid/a_grid.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// The area that has most of each cell's pixels; see AreaMap::cell_areas.
/// @param pixel_labels  see AreaMap::pixel_labels; `areas` sorted by id
std::vector<AreaId> labelCells(const AGrid& grid, const MapGeometry& geometry,
                               const std::vector<std::uint16_t>& pixel_labels,
                               const std::vector<Area>& areas);

/// The same after some pixels got other labels, looking at the cells that may have changed only.
/// @param changed  boxes of pixels outside of which no label and no id of a labelled area changed
/// @param cells  as they were
void relabelCells(const AGrid& grid, const MapGeometry& geometry,
                  const std::vector<std::uint16_t>& pixel_labels, const std::vector<Area>& areas,
                  const std::vector<cv::Rect>& changed, std::vector<AreaId>& cells);

/// The cells that a segment passes through: row-major indices, sorted, each once.
std::vector<std::uint32_t> cellsOnSegment(const AGrid& grid, const Segment& segment_map);

}  // namespace agrid
