// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/planning/planner.h"

namespace agrid {

/// The corners of the path from one point to another for a robot that turns on the spot, map frame
/// [m]; empty if there is none. A robot with an outline is taken for the planner's circle.
std::vector<Point2> wayBetween(const Planner& planner, const Point2& from_map,
                               const Point2& to_map);

}  // namespace agrid
