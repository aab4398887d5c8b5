// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// Two pixels of different areas that touch by a side.
struct BorderPoint {
  std::uint32_t a = 0;  ///< the areas, a < b
  std::uint32_t b = 0;
  std::size_t pixel = 0;  ///< row-major; the lower or left one
  std::size_t other = 0;  ///< the upper or right one

  /// Which of both pixels lies lower, the first if they are level.
  /// @param heights  row-major
  std::size_t lower(const float* heights) const {
    return heights[pixel] <= heights[other] ? pixel : other;
  }

  /// The middle between both pixels, in pixels of the image frame.
  Point2 position(const MapGeometry& geometry) const {
    const Pixel p = geometry.pixel(pixel);
    const Pixel q = geometry.pixel(other);
    return Point2(p.x + q.x + 1, p.y + q.y + 1) / 2;
  }
};

/// All of them, sorted by the areas, then by place.
/// @param labels  row-major: the number of each pixel's area, or Basins::kNone
std::vector<BorderPoint> findBorderPoints(const std::vector<std::uint32_t>& labels,
                                          const MapGeometry& geometry);

/// A connected piece of the border between two areas.
using Stretch = std::vector<BorderPoint>;

/// Splits border points as findBorderPoints returns them into stretches, whose points are at most
/// three pixels apart.
std::vector<Stretch> splitIntoStretches(const std::vector<BorderPoint>& points,
                                        const MapGeometry& geometry);

/// Diagonal of a stretch's bounding box, as the borders between rooms are measured [px].
double extentOf(const Stretch& stretch, const MapGeometry& geometry);

}  // namespace agrid
