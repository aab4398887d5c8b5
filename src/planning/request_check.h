// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "agrid/planning/planner.h"

namespace agrid::planning {

/// Name of the package's own planner.
constexpr const char* kOwnPlanner = "AGrid";

/// Longest time that a request may take [s].
constexpr double kMaxTimeout = 60;

/// A request with the parameters in place of what it leaves open.
struct Query {
  double robot_radius = 0;  ///< [m]; with a footprint: of a circle that fits where it does
  double timeout = 0;       ///< [s]
  std::string planner;
  double turning_radius = 0;  ///< [m]
  Motion motion = Motion::kReedsShepp;
  Polygon footprint;    ///< empty: a circle
  std::string problem;  ///< empty: the request is valid

  /// Whether the heading matters on the way.
  bool turns() const { return turning_radius > 0 || !footprint.empty(); }
};

/// @param resolution  of the map [m]
Query checkedQuery(const PlanRequest& request, const PlannerParams& params, double resolution);

/// @throws std::invalid_argument naming field, value and bound
void requireValid(const PlannerParams& params);

}  // namespace agrid::planning
