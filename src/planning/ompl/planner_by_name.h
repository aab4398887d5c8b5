// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planning/free_space.h"
#include "planning/portal_graph.h"
#include "planning/stop.h"

namespace agrid::planning {

/// Names of OMPL's geometric planners that can be asked for, sorted.
std::vector<std::string> omplPlannerNames();
bool isOmplPlanner(const std::string& name);

/// What one of OMPL's planners is asked for.
struct OmplQuery {
  std::string planner;
  FinePoint start;
  FinePoint goal;
  std::vector<PixelBox> lead;  ///< where most samples are drawn
  double good_length_px = 0;   ///< planners that improve their paths may stop at this length
  std::uint32_t seed = 0;
};

/// Plans with one of OMPL's planners in exactSpace(free), until it has a path or the time is up.
/// Approximate solutions, which end beside the goal, are none.
/// @return corners, each in sight of the next; empty if none was found in time
/// @throws Stopped if cancelled
std::vector<FinePoint> planByOmpl(const FreeSpace& free, const OmplQuery& query,
                                  const StopCheck& stop);

}  // namespace agrid::planning
