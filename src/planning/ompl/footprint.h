// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/geometry/polygon.h"

namespace agrid::planning {

/// The outline of a robot around the origin of its frame; either order of corners.
class Footprint {
 public:
  /// @param corners  [m or px], valid according to footprintProblem
  explicit Footprint(const Polygon& corners);

  /// Radius of the largest circle around the origin inside the outline, and of the smallest around
  /// it all.
  double innerRadius() const { return inner_radius_; }
  double outerRadius() const { return outer_radius_; }
  const Polygon& corners() const { return corners_; }

 private:
  Polygon corners_;
  double inner_radius_ = 0;
  double outer_radius_ = 0;
};

/// What is wrong with an outline, empty if nothing is: fewer than 3 or more than 1000 corners, a
/// number that is not finite, sides that meet elsewhere than at their corner, the origin outside.
std::string footprintProblem(const Polygon& corners);

/// Whether a point is inside of a polygon; on its border either answer is possible.
bool isInside(const Polygon& polygon, const Point2& point);

/// Distance between two segments, 0 where they meet.
double segmentDistance(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// Whether a polygon comes as near as `reach` to the closed square of side 1 around `center`.
bool isNearSquare(const Polygon& polygon, const Point2& center, double reach);

}  // namespace agrid::planning
