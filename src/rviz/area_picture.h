// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <agrid_map/AGrid.h>

namespace agrid_map_rviz {

/// The areas of an A-Grid as a picture, in the grid's frame: drawn as one face whose cost does not
/// grow with the number of cells.
struct AreaPicture {
  std::uint32_t width = 0, height = 0;  ///< 0: there is nothing to draw
  std::vector<std::uint8_t> rgba;       ///< four bytes a texel; the first row has the least y
  double left = 0, right = 0, low = 0, high = 0;  ///< what it covers [m]
};

/// Paints each texel as the area that its centre lies in, see areaColor; the rest is transparent.
/// @param texel  the side of a texel [m], larger where the picture would have more than `max_side`
/// @return nothing to draw if the message's lengths do not fit each other
AreaPicture paintAreas(const agrid_map::AGrid& grid, double texel, std::uint32_t max_side);

}  // namespace agrid_map_rviz
