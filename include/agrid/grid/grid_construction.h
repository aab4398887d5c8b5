// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "agrid/grid/a_grid.h"
#include "agrid/grid/wall_detection.h"

namespace agrid {

/// Bounds on the A-Grid.
struct GridParams {
  double max_cells = 4e6;  ///< beyond it the wall lines with the fewest votes go, with a warning
};

/// Splits the map's bounding rectangle into cells bounded by wall lines (paper, Alg. 2).
AGrid constructGrid(const Walls& walls, const GridParams& params = {});

}  // namespace agrid
