// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "agrid/semantic_map/thing_lookup.h"

namespace agrid {

/// What a thing covers of the plane, map frame [m]: a point, a straight line (two corners) or a
/// simple polygon with all that is inside.
struct Shape {
  explicit Shape(std::vector<Point2> corners_map);

  std::vector<Point2> corners;  ///< at least one
  Point2 low = Point2::Zero();  ///< bounding box
  Point2 high = Point2::Zero();
};

/// An area's outline, a door from jamb to jamb, an object's box. An area without an outline is its
/// anchor.
Shape shapeOf(const Thing& thing);

bool contains(const Shape& shape, const Point2& point);

/// The point of a shape nearest to another: itself, if the shape holds it.
Point2 nearestPoint(const Shape& shape, const Point2& point);

/// The least distance between points of two shapes [m]; 0 if they touch.
/// @param limit  what is farther apart may be said to be infinitely far, which is quicker
double distanceBetween(const Shape& a, const Shape& b,
                       double limit = std::numeric_limits<double>::infinity());

}  // namespace agrid
