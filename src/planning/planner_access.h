// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/planner_core.h"

namespace agrid::planning {

/// Lets OMPL's side of the library use what a Planner has prepared.
struct PlannerAccess {
  static const PlannerCore& core(const Planner& planner);
};

}  // namespace agrid::planning
