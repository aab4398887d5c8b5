// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "agrid/grid/a_grid.h"
#include "agrid/grid/wall_detection.h"

namespace agrid {

/// Bounds on the A-Grid.
struct GridParams {
  double max_cells = 4e6;  ///< beyond it weak wall lines beside strong ones go, with a warning
};

/// Splits the map's bounding rectangle into cells bounded by wall lines (paper, Alg. 2).
///
/// The edges of the rectangle count as lines: the cells tile it exactly. On each axis, d being the
/// smallest gap between two neighbouring lines, every gap of 2 d or more is halved until its parts
/// are smaller; all gaps end in [d, 2 d). A wall line on an edge is that edge. Without wall lines
/// an axis is one gap.
/// @throws std::invalid_argument if the extent is not positive, or a wall line lies outside it or
///         out of order
AGrid constructGrid(const Walls& walls);

/// Number of cells that constructGrid would make; does not make them.
double countCells(const Walls& walls);

/// Drops wall lines until the grid has at most `params.max_cells` cells, and says so in the
/// warnings. The number of cells hangs on the smallest gap: so of lines that lie close together the
/// one with the fewest votes goes, for the least distance that suffices. Walls of a grid that is
/// small enough come back as they are.
/// @throws std::invalid_argument if max_cells < 1, or for walls that constructGrid refuses
Walls limitCells(Walls walls, const GridParams& params = {});

}  // namespace agrid
