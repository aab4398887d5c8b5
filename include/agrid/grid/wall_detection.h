// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/geometry/pose2.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Constants of Alg. 1 and of the edge detector before it, in pixels and votes as in the paper. The
/// paper gives no value for those marked "chosen"; doc/paper.md tells how they were chosen.
struct WallParams {
  double canny_low = 1;               ///< lower threshold of the edge detector (paper, 3.1)
  double canny_high = 30;             ///< upper threshold of the edge detector (paper, 3.1)
  int max_threshold_votes = 350;      ///< accumulator threshold of the first round (chosen)
  int min_threshold_votes = 20;       ///< the rounds end when the threshold is this low (chosen)
  int threshold_step_votes = 10;      ///< decrease of the threshold per round (chosen)
  double min_line_distance_px = 5;    ///< least distance to a line already taken (chosen)
  double distance_resolution_px = 2;  ///< of the Hough accumulator (Alg. 1, line 3)
  bool estimate_direction = true;     ///< false: the grid lies along direction_deg
  double direction_deg = 0;  ///< direction of the walls where it is not estimated, from the
                             ///< image's x axis, counter-clockwise; 0 as in the paper
};

/// An infinite axis-aligned line of the grid frame on which wall edges lie.
struct WallLine {
  double offset = 0;  ///< x of a vertical line, y of a horizontal one, grid frame [m]
  int votes = 0;      ///< edge pixels on it
};

/// The walls of a map (paper, Alg. 1).
struct Walls {
  Pose2 map_from_grid;  ///< the grid frame: x and y along the walls
  Point2 extent =
      Point2::Zero();  ///< the map's bounding rectangle is [0, x] x [0, y], grid frame [m]
  std::vector<WallLine> vertical;     ///< sorted by offset, all inside (0, extent.x())
  std::vector<WallLine> horizontal;   ///< sorted by offset, all inside (0, extent.y())
  std::vector<std::string> warnings;  ///< e.g. that no wall was found
};

/// Finds the lines on which walls lie (paper, Alg. 1): the edges of the map drawn as free 254,
/// unknown 205, occupied 0, a Hough transform restricted to two directions, and rounds of falling
/// threshold in which a line is taken if it lies far enough from all lines taken before.
///
/// The two directions are those of the grid frame. By default they are estimated
/// (main_direction.h), and the edge pixels of a turned building are turned before they vote. The
/// edges of the bounding rectangle count as taken, so no wall line is nearer to them than to
/// another wall line.
/// @return lines at least max(max_threshold / threshold, min_line_distance) pixels apart, threshold
///         being that of the round in which the later one was taken
/// @throws std::invalid_argument if a parameter is out of its range
Walls detectWalls(const OccupancyMap& map, const WallParams& params = {});

}  // namespace agrid
