// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/topology/route.h"
#include "planning/free_space.h"
#include "planning/obstacles.h"

namespace agrid::planning {

/// The pixels whose inside a path crosses, in order of travel; none twice in a row.
std::vector<Pixel> crossedPixels(const std::vector<FinePoint>& path);

/// The areas of those pixels, in order, and the doors between them: where two areas meet, the
/// nearest of their doors. Pixels without an area are passed over. The length is left at 0.
Route crossedAreas(const SemanticMap& map, const std::vector<Pixel>& pixels);

/// The door between two areas (indices into AreaMap::areas) that is nearest to a point of the map
/// frame; kNoDoor if they have none.
std::size_t doorBetween(const AreaMap& areas, std::size_t a, std::size_t b, const Point2& near_map);

/// Smallest distance from a path to the square of an obstacle pixel [px]: exact up to 64 px, beyond
/// it too small by at most 1.42 px; infinite without obstacles.
double pathClearancePx(const FreeSpace& free, const Obstacles& obstacles,
                       const std::vector<FinePoint>& path);

}  // namespace agrid::planning
