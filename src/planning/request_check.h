// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "agrid/planning/planner.h"

namespace agrid::planning {

/// Longest time that a request may take [s].
constexpr double kMaxTimeout = 60;

/// A request with the parameters in place of what it leaves open.
struct Query {
  double robot_radius = 0;  ///< [m]
  double timeout = 0;       ///< [s]
  std::string planner;
  std::string problem;  ///< empty: the request is valid
};

Query checkedQuery(const PlanRequest& request, const PlannerParams& params);

/// @throws std::invalid_argument naming field, value and bound
void requireValid(const PlannerParams& params);

}  // namespace agrid::planning
