// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Labels the free pixels whose centres lie within a polygon by the even-odd rule, holes being
/// further rings; those that have a label keep it.
/// @param rings_px  in pixels of the image frame (y up, pixel (0, 0) covers [0, 1) x [0, 1))
/// @param labels  row-major like the map
void paintPolygon(const std::vector<Polygon>& rings_px, std::uint16_t label,
                  const OccupancyMap& map, std::vector<std::uint16_t>& labels);

/// A ring of the map frame [m] in pixels of the image frame.
Polygon pixelRing(const Polygon& ring_map, const MapGeometry& geometry);

}  // namespace agrid
