// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tags/basins.h"
#include "tags/borders.h"
#include "tags/openings.h"
#include "tags/relief.h"

namespace agrid {

/// Pieces of free space small enough that no area ends inside one.
struct Fragments {
  /// The fragments as basins of the open relief; their saddles lead across openings too.
  Basins basins;
  std::vector<BorderPoint> borders;  ///< between them, as findBorderPoints returns them
  Openings openings;
};

/// Cuts the relief at its openings and at every narrowing of its own: basins of the distance from
/// walls and openings stay apart if the saddle between them is below 0.95 of the lower peak and
/// 0.05 m below it. Fragments under 0.3 m^2 join the neighbour that they open to the widest.
Fragments cutIntoFragments(const Relief& relief, double resolution);

}  // namespace agrid
