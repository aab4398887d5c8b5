// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/map/occupancy_map.h"

#include <array>
#include <cmath>
#include <sstream>

#include "map/digest.h"

namespace agrid {
namespace {

constexpr double kMinResolution = 0.001;  // [m]
constexpr double kMaxResolution = 10;     // [m]
constexpr double kMaxOrigin = 1e6;        // [m]

template <typename... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  (text << ... << parts);
  return text.str();
}

void checkParams(const MapParams& params) {
  if (params.free_max < 0 || params.free_max > 99) {
    throw std::invalid_argument(message("free_max is ", params.free_max, ", must be in [0, 99]"));
  }
  if (params.occupied_min <= params.free_max || params.occupied_min > 100) {
    throw std::invalid_argument(message("occupied_min is ", params.occupied_min, ", must be in [",
                                        params.free_max + 1, ", 100]"));
  }
  if (!(params.max_pixels >= 1)) {
    throw std::invalid_argument(
        message("max_pixels is ", params.max_pixels, ", must be at least 1"));
  }
}

void checkSize(const OccupancyGrid& grid, double max_pixels) {
  const MapGeometry& g = grid.geometry;
  if (g.width <= 0 || g.height <= 0) {
    throw MapError(MapErrorCode::kSize, message("map of ", g.width, " x ", g.height,
                                                " pixels: width and height must be positive"));
  }
  if (!(static_cast<double>(g.pixelCount()) <= max_pixels)) {
    throw MapError(MapErrorCode::kCap,
                   message("map of ", g.width, " x ", g.height, " = ", g.pixelCount(),
                           " pixels: at most ", max_pixels, " are allowed (max_pixels)"));
  }
  if (grid.values.size() != g.pixelCount()) {
    throw MapError(MapErrorCode::kSize,
                   message("map data holds ", grid.values.size(), " values, width x height is ",
                           g.width, " x ", g.height, " = ", g.pixelCount()));
  }
}

void checkPlacement(const MapGeometry& geometry) {
  if (!(geometry.resolution >= kMinResolution && geometry.resolution <= kMaxResolution)) {
    throw MapError(MapErrorCode::kResolution,
                   message("map resolution is ", geometry.resolution, " m, must be in [",
                           kMinResolution, ", ", kMaxResolution, "]"));
  }
  const Pose2& origin = geometry.map_from_image;
  if (!(std::abs(origin.position.x()) <= kMaxOrigin &&
        std::abs(origin.position.y()) <= kMaxOrigin)) {
    throw MapError(MapErrorCode::kOrigin,
                   message("map origin is (", origin.position.x(), ", ", origin.position.y(),
                           ") m, both must be in [-", kMaxOrigin, ", ", kMaxOrigin, "]"));
  }
  if (!std::isfinite(origin.yaw)) {
    throw MapError(MapErrorCode::kOrigin,
                   message("map origin yaw is ", origin.yaw, " rad, must be finite"));
  }
}

struct Classes {
  std::array<Occupancy, 256> of_byte;  // by the value's bit pattern
  std::array<bool, 256> allowed;
};

Classes classesFor(const MapParams& params) {
  Classes classes{};
  for (int byte = 0; byte < 256; ++byte) {
    const int value = byte < 128 ? byte : byte - 256;
    const auto i = static_cast<std::size_t>(byte);
    classes.allowed[i] = value >= -1 && value <= 100;
    classes.of_byte[i] = value < 0 || value > 100       ? Occupancy::kUnknown
                         : value <= params.free_max     ? Occupancy::kFree
                         : value >= params.occupied_min ? Occupancy::kOccupied
                                                        : Occupancy::kUnknown;
  }
  return classes;
}

}  // namespace

OccupancyMap::OccupancyMap(const OccupancyGrid& grid, const MapParams& params) {
  checkParams(params);
  checkSize(grid, params.max_pixels);
  checkPlacement(grid.geometry);
  const Classes classes = classesFor(params);
  geometry_ = grid.geometry;
  pixels_.reserve(grid.values.size());
  std::size_t odd_count = 0;
  int odd_value = 0;
  for (const std::int8_t value : grid.values) {
    const auto byte = static_cast<std::uint8_t>(value);
    pixels_.push_back(classes.of_byte[byte]);
    if (classes.allowed[byte]) continue;
    if (odd_count++ == 0) odd_value = value;
  }
  if (odd_count > 0) {
    const std::string what =
        message(odd_count, " map values lie outside [-1, 100], the first is ", odd_value);
    if (params.strict_values) throw MapError(MapErrorCode::kValue, what);
    warnings_.push_back(what + "; they are taken as unknown");
  }
  digest_ = mapDigest(geometry_, pixels_);
}

}  // namespace agrid
