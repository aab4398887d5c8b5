// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "agrid/geometry/segment.h"
#include "tags/sight.h"
#include "tags/wall_corners.h"

namespace agrid {

/// A line across free space that may part two areas: between two jambs, image frame [px].
struct Opening {
  Segment jambs;
  double wall_before = 0;  ///< how far the line has wall on it beyond jamb a [px]
  double wall_beyond = 0;  ///< ... beyond jamb b [px]
  double merit = 0;        ///< which of two that exclude each other stays [m]
};

/// Gaps in walls: a wall ends at a corner, and its line meets a wall again within 4 m. The paper's
/// 'regularity in the structure' (3.2), along the walls of the map instead of its axes. A gap is
/// kept if there is wall on its line on either side, for half of its own width in sum, or 0.8 m
/// before it; or if walls make up most of its line within 2.5 m.
std::vector<Opening> findWallGaps(const std::vector<WallCorner>& corners,
                                  const WallDirections& walls, const Sight& sight);

/// Mouths: two corners within 3 m where a narrow place, with walls within 30 degrees of parallel,
/// opens to a wide one, whose walls spread by 20 degrees or more on either side.
std::vector<Opening> findMouths(const std::vector<WallCorner>& corners, const WallDirections& walls,
                                const Sight& sight);

/// All openings of a map and where they lie.
struct Openings {
  std::vector<Opening> all;
  /// Which of them lies on a pixel, by its row-major index.
  std::unordered_map<std::size_t, std::uint32_t> at_pixel;
};

/// Gaps and mouths, from the best to the worst; of those that cross or have the same jambs within
/// 0.5 m only the best. None in maps coarser than 0.2 m, where the end of a wall is a pixel or two
/// and points nowhere.
std::vector<Opening> findOpenings(const cv::Mat1b& free_space, const Sight& sight);

}  // namespace agrid
