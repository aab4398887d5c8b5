// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "agrid/grid/wall_detection.h"

namespace agrid {

/// Parallel lines that keep their distance from each other and from the two edges of the map. The
/// unit is the caller's.
class SpacedLines {
 public:
  explicit SpacedLines(double extent) : votes_{{0, 0}, {extent, 0}} {}

  /// Takes the line if it lies between the edges and at least `min_distance` from each of them and
  /// from each line taken before (Alg. 1, lines 8 to 14, in O(log n)).
  void addIfFar(const WallLine& line, double min_distance);

  /// The lines taken, by offset, without the edges.
  std::vector<WallLine> lines() const;

 private:
  std::map<double, int> votes_;  // by offset
};

}  // namespace agrid
