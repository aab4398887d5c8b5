// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "planning/subject.h"

namespace agrid::bench {

struct Effort {
  double robot_radius = 0.2;      ///< [m]
  int drawn_pairs = 100;          ///< where a map has none
  double reference_seconds = 60;  ///< for each map: A* and, on generated maps, reference lengths
};

/// What the benchmark says about one map. Seconds, pixels, bytes; NaN: not measured.
struct Figures {
  std::string map;
  double megapixels = 0;
  std::size_t pairs = 0;
  std::size_t false_no = 0;
  std::size_t false_found = 0;
  std::size_t not_free = 0;  ///< paths that touch a blocked pixel, or start, end or measure wrong
  bool best_known = false;   ///< lengths are compared with the best known ones, not our reference
  std::vector<double> length_ratios;
  std::vector<double> bound_gaps;     ///< length / length_bound - 1
  std::vector<double> query_seconds;  ///< of the pairs with a path
  std::vector<double> no_path_seconds;
  std::vector<double> transform_seconds;       ///< before and after the queries
  std::vector<double> a_star_seconds;          ///< on some of the pairs
  std::vector<double> compared_query_seconds;  ///< the planner's, on the same
  double build_seconds = 0;
  double bytes = 0;                        ///< kept by the planner after all queries
  std::vector<double> door_seconds;        ///< a door closed or opened, until the planner is ready
  std::vector<double> first_plan_seconds;  ///< the same until the first path past the door
};

/// Measures one map. Every answer is checked against a flood fill, every path against the pixels.
Figures measure(const Subject& subject, const Effort& effort);

}  // namespace agrid::bench
