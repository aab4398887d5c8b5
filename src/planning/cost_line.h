// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/cost_field.h"

namespace agrid::planning {

/// What a straight line costs: each part of it times the factor of the pixel in which it lies;
/// infinite if it touches the closed square of a blocked pixel, or of none at all [px].
double costOfLine(const CostField& field, const Point2& a, const Point2& b);

/// A way with corners left out where the straight line costs no more [px].
/// @param way  a step at most 1.5 px long, each free
std::vector<Point2> pulledStraight(const CostField& field, const std::vector<Point2>& way);

/// The same way with a point at least every `step` [px].
std::vector<Point2> resampled(const std::vector<Point2>& way, double step);

}  // namespace agrid::planning
