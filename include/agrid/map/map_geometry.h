// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "agrid/geometry/pose2.h"

namespace agrid {

/// Column and row of a pixel of the metric map; row 0 has the smallest y, as in
/// nav_msgs/OccupancyGrid.
struct Pixel {
  int x = 0;
  int y = 0;
};

inline bool operator==(Pixel a, Pixel b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(Pixel a, Pixel b) { return !(a == b); }

/// Where the pixels of a metric map lie. The image frame has its origin at the lower left corner of
/// pixel (0, 0) and its axes along the columns and rows; its unit is the metre.
struct MapGeometry {
  int width = 0;          ///< columns
  int height = 0;         ///< rows
  double resolution = 1;  ///< side of a pixel [m]
  Pose2 map_from_image;   ///< pose of the lower left corner of pixel (0, 0) in the map frame

  std::size_t pixelCount() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  bool contains(Pixel p) const { return p.x >= 0 && p.y >= 0 && p.x < width && p.y < height; }

  /// Position in row-major data; `p` must be contained.
  std::size_t index(Pixel p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(p.x);
  }
  Pixel pixel(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }

  /// Centre of a pixel, map frame [m].
  Point2 center(Pixel p) const {
    return map_from_image * Point2((p.x + 0.5) * resolution, (p.y + 0.5) * resolution);
  }
  /// The pixel that holds a point of the map frame [m]; none outside the map or for NaN.
  std::optional<Pixel> pixelAt(const Point2& point_map) const {
    const Point2 q = inverse(map_from_image) * point_map / resolution;
    if (!(q.x() >= 0 && q.y() >= 0 && q.x() < width && q.y() < height)) return std::nullopt;
    return Pixel{static_cast<int>(q.x()), static_cast<int>(q.y())};
  }
};

}  // namespace agrid
