// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "agrid/map/map_geometry.h"

namespace agrid::planning {

/// Fine steps in a pixel. Products of two map sides in fine steps stay below 2^61 up to 1e9 pixels.
constexpr std::int64_t kFine = 1 << 15;

/// A point of the metric map on a lattice of 1/32768 pixel, so that lines of sight are decided in
/// integers. Pixel (i, j) has its centre at (i, j) * kFine and covers half a pixel around it.
struct FinePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  /// The pixel that holds the point; a point on a border belongs to the higher one.
  Pixel pixel() const {
    const auto floor = [](std::int64_t v) {
      const std::int64_t shifted = v + kFine / 2;
      return static_cast<int>(shifted >= 0 ? shifted / kFine : -((-shifted + kFine - 1) / kFine));
    };
    return {floor(x), floor(y)};
  }
};

inline bool operator==(FinePoint a, FinePoint b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(FinePoint a, FinePoint b) { return !(a == b); }

inline FinePoint centerOf(Pixel p) { return {p.x * kFine, p.y * kFine}; }

/// The corner below and to the left of a pixel.
inline FinePoint lowerCornerOf(Pixel p) {
  return {p.x * kFine - kFine / 2, p.y * kFine - kFine / 2};
}

/// Nearest point of the lattice.
/// @param coordinates  in pixels, pixel centres at integers
inline FinePoint finePoint(const Point2& coordinates) {
  return {std::llround(coordinates.x() * static_cast<double>(kFine)),
          std::llround(coordinates.y() * static_cast<double>(kFine))};
}

/// The point in the inside of a pixel that is nearest to the wanted one: on its border it would
/// touch the pixels beside.
inline FinePoint insidePixel(Pixel p, FinePoint wanted) {
  const FinePoint center = centerOf(p);
  constexpr std::int64_t kReach = kFine / 2 - 1;
  return {std::clamp(wanted.x, center.x - kReach, center.x + kReach),
          std::clamp(wanted.y, center.y - kReach, center.y + kReach)};
}

/// In pixels, pixel centres at integers.
inline Point2 coordinates(FinePoint p) {
  return Point2(static_cast<double>(p.x), static_cast<double>(p.y)) / static_cast<double>(kFine);
}

inline double distancePx(FinePoint a, FinePoint b) {
  return (coordinates(a) - coordinates(b)).norm();
}

/// A point of the map frame [m] in pixels, pixel centres at integers.
inline Point2 pixelCoordinates(const MapGeometry& geometry, const Point2& point_map) {
  return inverse(geometry.map_from_image) * point_map / geometry.resolution - Point2(0.5, 0.5);
}

/// The same point in the map frame [m].
inline Point2 mapPoint(const MapGeometry& geometry, FinePoint p) {
  return geometry.map_from_image *
         Point2((coordinates(p) + Point2(0.5, 0.5)) * geometry.resolution);
}

}  // namespace agrid::planning
