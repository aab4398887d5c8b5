// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "agrid/geometry/point2.h"

namespace agrid {

/// A straight piece of a line [m].
struct Segment {
  Point2 a = Point2::Zero();
  Point2 b = Point2::Zero();

  double length() const { return (b - a).norm(); }
  Point2 midpoint() const { return (a + b) / 2; }
};

}  // namespace agrid
