// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/geometry/pose2.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Constants of Alg. 1 and of the edge detector before it, in pixels and votes as in the paper.
struct WallParams {
  double canny_low = 1;               ///< lower threshold of the edge detector (paper, 3.1)
  double canny_high = 30;             ///< upper threshold of the edge detector (paper, 3.1)
  int max_threshold_votes = 200;      ///< first accumulator threshold (paper gives no value)
  int min_threshold_votes = 20;       ///< the loop ends at this threshold (paper gives no value)
  int threshold_step_votes = 10;      ///< decrease per round (paper gives no value)
  double min_line_distance_px = 4;    ///< least distance to a line already taken
  double distance_resolution_px = 2;  ///< of the accumulator (Alg. 1, line 4)
  bool estimate_direction = true;     ///< false: the grid lies along the image, as in the paper
  double direction_deg = 0;           ///< direction of the walls where it is not estimated
};

/// An infinite axis-aligned line of the grid frame on which wall edges lie.
struct WallLine {
  double offset = 0;  ///< x of a vertical line, y of a horizontal one, grid frame [m]
  int votes = 0;      ///< edge pixels on it when it was taken
};

/// The walls of a map (paper, Alg. 1).
struct Walls {
  Pose2 map_from_grid;  ///< the grid frame: x and y along the walls
  Point2 extent =
      Point2::Zero();  ///< the map's bounding rectangle is [0, x] x [0, y], grid frame [m]
  std::vector<WallLine> vertical;     ///< sorted by offset
  std::vector<WallLine> horizontal;   ///< sorted by offset
  std::vector<std::string> warnings;  ///< e.g. that no wall was found
};

/// Finds the lines on which walls lie (paper, Alg. 1: Canny, Hough transform, adaptive acceptance).
Walls detectWalls(const OccupancyMap& map, const WallParams& params = {});

}  // namespace agrid
