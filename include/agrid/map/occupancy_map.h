// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// An occupancy grid as it comes from a file or a message: nothing is checked yet.
struct OccupancyGrid {
  MapGeometry geometry;
  std::vector<std::int8_t> values;  ///< row-major, row 0 = smallest y; 0..100, -1 unknown
};

/// What a pixel of the metric map is known to be.
enum class Occupancy : std::uint8_t { kFree, kOccupied, kUnknown };

/// What of a map is refused.
enum class MapErrorCode { kSize, kCap, kResolution, kOrigin, kFrame, kValue };

/// A map that cannot be used; `what()` names the value, the bound and the field.
class MapError : public std::invalid_argument {
 public:
  MapError(MapErrorCode code, const std::string& what) : std::invalid_argument(what), code_(code) {}
  MapErrorCode code() const { return code_; }

 private:
  MapErrorCode code_;
};

/// How values become free, occupied and unknown, and which maps are taken at all.
struct MapParams {
  int free_max = 25;        ///< values of 0..free_max are free; map_saver's bound
  int occupied_min = 65;    ///< values of occupied_min..100 are occupied; map_saver's bound
  double max_pixels = 1e9;  ///< larger maps are refused
  bool strict_values =
      false;  ///< refuse values outside [-1, 100] instead of taking them as unknown
};

/// The metric map: each pixel is free, occupied or unknown. Immutable.
class OccupancyMap {
 public:
  /// @throws MapError if the size does not match the data or exceeds `params.max_pixels`, the
  ///         resolution lies outside [0.001, 10] m, the origin is not finite or beyond 1e6 m, or a
  ///         value is not allowed
  explicit OccupancyMap(const OccupancyGrid& grid, const MapParams& params = {});

  const MapGeometry& geometry() const { return geometry_; }
  Occupancy at(Pixel p) const { return pixels_[geometry_.index(p)]; }
  bool isFree(Pixel p) const { return at(p) == Occupancy::kFree; }
  const std::vector<Occupancy>& pixels() const { return pixels_; }  ///< row-major, row 0 = lowest y

  /// Fingerprint of geometry and pixels: 16 hexadecimal digits, equal on every machine.
  const std::string& digest() const { return digest_; }
  /// What was accepted but looks wrong, a sentence each.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  MapGeometry geometry_;
  std::vector<Occupancy> pixels_;
  std::string digest_;
  std::vector<std::string> warnings_;
};

}  // namespace agrid
