// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// The space that areas are made of: the known free pixels, without small islands, and with the
/// clutter that stands in them taken away.
/// @return row-major like the map, 1 = free, 0 = wall, unknown or left out
cv::Mat1b cleanFreeSpace(const OccupancyMap& map, const AreaParams& params);

/// Distance of each free pixel's centre from the nearest centre that is not free, in pixels; what
/// lies beyond the map is not free.
cv::Mat1f distanceFromWalls(const cv::Mat1b& free_space);

}  // namespace agrid
