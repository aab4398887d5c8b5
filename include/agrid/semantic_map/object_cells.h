// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/grid/a_grid.h"
#include "agrid/semantic_map.h"

namespace agrid {

/// Whether an object's bounding box, turned by its yaw, overlaps a cell of the grid. Boxes that
/// only touch a cell's sides do not; a box without a width or a depth is a line or a point, and
/// lies in the cells that hold it. A pose or size that is not finite overlaps nothing.
bool overlaps(const AGrid& grid, const ObjectTag& object, Cell cell);

/// The cells that an object overlaps, as row-major indices in rising order; empty if it lies
/// outside the grid.
std::vector<std::uint32_t> cellsOf(const SemanticMap& map, const ObjectTag& object);

}  // namespace agrid
