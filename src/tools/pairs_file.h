// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "agrid/geometry/point2.h"

namespace agrid::tools {

/// A start and a goal in pixels of the map's image: pixel centres at integers, y down from the top.
struct Pair {
  std::string id;  ///< letters, digits, '-' and '_'
  Point2 start_px = Point2::Zero();
  Point2 goal_px = Point2::Zero();
  std::optional<double> best_known_px{};  ///< length of the best collision-free path known
};

/// Reads the columns id, start_x_px, start_y_px, goal_x_px and goal_y_px of a CSV file with a
/// header, and best_known_length_px if it is there (an empty field: not known); others are passed
/// over.
/// @throws FileError naming the path, and the line where there is one
std::vector<Pair> readPairs(const std::string& path);

}  // namespace agrid::tools
