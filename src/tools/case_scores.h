// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "agrid/evaluation/scores.h"
#include "agrid/map/occupancy_map.h"
#include "tools/eval_cases.h"
#include "tools/pipeline_options.h"

namespace agrid::tools {

/// A way to look at the same place with another map.
struct View {
  std::string name;
  std::function<OccupancyMap(const OccupancyMap&)> make;  ///< empty: the map as it is
};

/// The map as it is and, if asked for, turned, in other resolutions and with noise.
std::vector<View> evalViews(bool robustness);

/// How well areas and doors agree with the truth.
struct ViewScores {
  AreaScores areas;
  DoorScores doors;
  bool doors_complete = true;  ///< whether the precision of the doors says something
};

struct CaseScores {
  EvalCase about;
  std::vector<ViewScores> views;      ///< in the order of the views
  std::vector<std::string> warnings;  ///< of the map's file
};

/// Finds areas and doors in each view of a map, and compares them on the pixels of the map itself.
/// @throws FileError if map or truth cannot be read or don't fit each other
CaseScores scoreCase(const EvalCase& about, const ConversionParams& params,
                     const std::vector<View>& views);

}  // namespace agrid::tools
