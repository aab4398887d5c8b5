// SPDX-License-Identifier: BSD-3-Clause
#include "planning/target.h"

#include <algorithm>
#include <cmath>

namespace agrid::planning {
namespace {

double gap(double low, double high, double value) {
  return std::max({0.0, low - value, value - high});
}

}  // namespace

double Target::distanceFrom(FinePoint p) const {
  if (point) return distancePx(p, *point);
  const Point2 from = coordinates(p);
  return std::hypot(gap(box.low.x - 0.5, box.high.x + 0.5, from.x()),
                    gap(box.low.y - 0.5, box.high.y + 0.5, from.y()));
}

}  // namespace agrid::planning
