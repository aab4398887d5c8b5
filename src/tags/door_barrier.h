// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/segment.h"
#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// A door tag as the segment that closes it (paper, 3.2).
struct Barrier {
  DoorTag tag;
  Segment jambs_map;                ///< up to the walls' surface [m]
  std::vector<std::size_t> pixels;  ///< touching by their sides; row-major indices
};

/// Finds the segment that closes a door: across the tag's pose, as wide as the tag says. It ends at
/// the first wall, and is carried on to a wall that begins within 0.3 m of its end, because nobody
/// measures a door to the pixel.
/// @return none if the centre of the door does not lie in free space
std::optional<Barrier> findBarrier(const cv::Mat1b& free_space, const MapGeometry& geometry,
                                   const DoorTag& tag);

/// Adds the barriers to the contours of the map (paper, 3.2).
void closeDoors(const std::vector<Barrier>& barriers, cv::Mat1b& free_space);

}  // namespace agrid
