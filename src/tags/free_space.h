// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// The space that areas are made of: the known free pixels, without small islands, and with the
/// clutter that stands in them taken away.
/// @return row-major like the map, 1 = free, 0 = wall, unknown or left out
cv::Mat1b cleanFreeSpace(const OccupancyMap& map, const AreaParams& params);

/// The squared distance of each pixel's centre to the nearest centre of a pixel that is not free,
/// also those that would lie around the map [px^2].
/// @param free_space  not 0: free
/// @return row-major
std::vector<std::int32_t> squaredDistancesFromWalls(const cv::Mat1b& free_space);

/// Distance of each free pixel's centre from the nearest centre that is not free, in pixels; what
/// lies beyond the map is not free.
cv::Mat1f distanceFromWalls(const cv::Mat1b& free_space);

}  // namespace agrid
