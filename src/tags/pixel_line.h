// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "agrid/geometry/point2.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// Walks along a line through every pixel that it crosses (Amanatides and Woo, 1987), so that the
/// pixels touch by their sides and nothing slips between them.
/// @param start_px, direction  image frame in pixels; pixel (x, y) covers [x, x + 1) x [y, y + 1)
/// @param visit  called with the pixel and the distance from the start at which it is entered, in
///               lengths of `direction`; the walk ends where it returns false
template <typename Visit>
void walkPixels(const Point2& start_px, const Point2& direction, Visit visit) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  Pixel p{static_cast<int>(std::floor(start_px.x())), static_cast<int>(std::floor(start_px.y()))};
  const int step_x = direction.x() > 0 ? 1 : -1;
  const int step_y = direction.y() > 0 ? 1 : -1;
  const auto firstCrossing = [&](double start, double slope, int pixel) {
    return slope == 0 ? kNever : (pixel + (slope > 0 ? 1 : 0) - start) / slope;
  };
  double next_x = firstCrossing(start_px.x(), direction.x(), p.x);
  double next_y = firstCrossing(start_px.y(), direction.y(), p.y);
  const double period_x = direction.x() == 0 ? kNever : 1 / std::abs(direction.x());
  const double period_y = direction.y() == 0 ? kNever : 1 / std::abs(direction.y());
  double entered = 0;
  while (visit(p, entered)) {
    entered = std::min(next_x, next_y);
    if (next_x < next_y) {
      p.x += step_x;
      next_x += period_x;
    } else {
      p.y += step_y;
      next_y += period_y;
    }
  }
}

}  // namespace agrid
