// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/map_geometry.h"

namespace agrid::planning {

/// The pixels that a door blocks when it is closed: all that the segment from jamb to jamb touches.
/// A jamb that ends short of its wall by up to three pixels is taken to it, so that nothing slips
/// past.
/// @param isOpen  whether a pixel, by its index, is no wall
std::vector<std::size_t> doorPixels(const MapGeometry& geometry, const Segment& jambs_map,
                                    const std::function<bool(std::size_t)>& isOpen);

}  // namespace agrid::planning
