// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag_proposal.h"
#include "tags/basins.h"
#include "tags/door_barrier.h"

namespace agrid {

/// The map as a landscape: the farther from the walls, the higher; doors are closed.
struct Relief {
  cv::Mat1b free_space;           ///< see cleanFreeSpace; 0 on the barriers
  std::vector<Barrier> barriers;  ///< of the door tags that could be used
  cv::Mat1f height;               ///< see distanceFromWalls [px]
  std::vector<std::string> warnings;
};

/// @param tags  its door tags become barriers; others are passed over
Relief makeRelief(const OccupancyMap& map, const std::vector<Tag>& tags, const AreaParams& params);

}  // namespace agrid
