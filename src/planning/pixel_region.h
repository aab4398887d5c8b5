// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid::planning {

/// A set of a map's pixels that is cheap to empty and to fill anew.
class PixelRegion {
 public:
  /// Empties it.
  void reset(const MapGeometry& geometry);
  bool contains(std::size_t pixel_index) const { return inside_[pixel_index] != 0; }
  /// Adds a disc [px, pixel centres at integers].
  void addDisc(const Point2& center, double radius);
  /// Adds discs along a line, so close that they make a band [px].
  void addBand(const Point2& a, const Point2& b, double radius);

 private:
  MapGeometry geometry_;
  std::vector<std::uint8_t> inside_;
  std::vector<std::size_t> members_;
};

}  // namespace agrid::planning
