// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "areas/area_labels.h"
#include "tags/relief.h"

namespace agrid {

/// What the guess of an area's category rests on. Neither position nor direction, and no pixels:
/// the same area has the same shape however the map is turned or resolved.
struct AreaShape {
  double size = 0;            ///< with the clutter that stands in it [m^2]
  double mean_clearance = 0;  ///< of its pixels, from the walls [m]
  double max_clearance = 0;   ///< of the place that is farthest from the walls [m]
  std::size_t doors = 0;      ///< doors and passages to other areas
};

/// What kind of area people would take this shape for: "corridor", "room", "hall" or "closet".
///
/// Width and length are those of the rectangle that has the same size and mean clearance: for a
/// corridor, however often it bends, branches or closes to a ring, its width and the length of its
/// middle line. The bounds, and where they come from, stand with the code and in doc/areas.md.
std::string guessCategory(const AreaShape& shape);

/// Sets `category_guess` of each area; `category`, which people give, stays as it is.
/// @param areas  those of `labels`, in its order
/// @param doors  between them
void guessCategories(const AreaLabels& labels, const Relief& relief, double resolution,
                     const std::vector<Door>& doors, std::vector<Area>& areas);

}  // namespace agrid
