// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
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

/// A border between two areas, compared with the truth.
struct JudgedDoor {
  std::uint32_t id = 0;  ///< as in graph.json of `convert`
  DoorKind kind = DoorKind::kDoor;
  double width = 0;  ///< [m]
  double confidence = 0;
  bool is_true = false;
};

struct CaseScores {
  EvalCase about;
  std::vector<ViewScores> views;  ///< in the order of the views
  std::vector<JudgedDoor> doors;  ///< in the first view; none if the true ones are not all known
  std::vector<std::string> warnings;  ///< of the map's file
};

/// Finds areas and doors in each view of a map, and compares them on the pixels of the map itself.
/// @throws FileError if map or truth cannot be read or don't fit each other
CaseScores scoreCase(const EvalCase& about, const ConversionParams& params,
                     const std::vector<View>& views);

}  // namespace agrid::tools
