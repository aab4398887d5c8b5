// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// Whether a point lies in a polygon, both in the same frame (crossings of a ray).
bool contains(const Polygon& polygon, const Point2& point);

/// Surface of a simple polygon [unit of its corners, squared].
double surface(const Polygon& polygon);

/// The outlines of areas, to find the one at a point.
class OutlineIndex {
 public:
  /// @param areas  must live as long as this
  explicit OutlineIndex(const std::vector<AreaTag>& areas);
  /// The index of the smallest area whose outline holds a point of the map frame.
  std::optional<std::size_t> smallestAt(const Point2& point_map) const;

 private:
  struct Box {
    Point2 low;
    Point2 high;
    std::size_t area = 0;
    double size = 0;
  };
  const std::vector<AreaTag>& areas_;
  std::vector<Box> boxes_;  ///< the smallest first
};

}  // namespace agrid
