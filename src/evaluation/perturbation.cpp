// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/perturbation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "evaluation/random_source.h"

namespace agrid {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSlack = 1e-6;   // [px] of rounding, and of single-precision resolutions
constexpr double kMaxSide = 1e6;  // [px]
constexpr double kFullCircle = 360;
constexpr int kWorn = 300;  // [per mille] of the free pixels at obstacles
constexpr int kStray = 1;   // [per mille] of the others

/// Where the pixels of one map lie in the image frame of another.
class PixelMap {
 public:
  PixelMap(const MapGeometry& to, const MapGeometry& from) : from_(from) {
    const Pose2 from_from_to = inverse(from.map_from_image) * to.map_from_image;
    const double scale = to.resolution / from.resolution;
    cos_ = std::cos(from_from_to.yaw) * scale;
    sin_ = std::sin(from_from_to.yaw) * scale;
    shift_ = from_from_to.position / from.resolution;
  }
  /// The row-major index of the pixel that holds the centre of `p`.
  std::optional<std::size_t> operator()(Pixel p) const {
    const double u = p.x + 0.5;
    const double v = p.y + 0.5;
    // Centres that fall on a side between two pixels must all go the same way.
    const double x = std::floor(cos_ * u - sin_ * v + shift_.x() + kSlack);
    const double y = std::floor(sin_ * u + cos_ * v + shift_.y() + kSlack);
    if (!(x >= 0 && y >= 0 && x < from_.width && y < from_.height)) return std::nullopt;
    return from_.index({static_cast<int>(x), static_cast<int>(y)});
  }

 private:
  const MapGeometry& from_;
  double cos_ = 1;
  double sin_ = 0;
  Point2 shift_ = Point2::Zero();
};

std::int8_t valueOf(Occupancy occupancy) {
  constexpr std::array<std::int8_t, 3> kValues{0, 100, -1};
  return kValues[static_cast<std::size_t>(occupancy)];
}

OccupancyMap resampledOn(const MapGeometry& geometry, const OccupancyMap& map) {
  OccupancyGrid grid;
  grid.geometry = geometry;
  grid.values.reserve(geometry.pixelCount());
  const PixelMap source(geometry, map.geometry());
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const auto i = source({x, y});
      grid.values.push_back(valueOf(i ? map.pixels()[*i] : Occupancy::kUnknown));
    }
  }
  return OccupancyMap(grid);
}

int roundedUp(double size) { return static_cast<int>(std::ceil(size - kSlack)); }

}  // namespace

bool touchesObstacle(const OccupancyMap& map, Pixel p) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Pixel q{p.x + dx, p.y + dy};
      if (map.geometry().contains(q) && !map.isFree(q)) return true;
    }
  }
  return false;
}

OccupancyMap turned(const OccupancyMap& map, double degrees) {
  const MapGeometry& old = map.geometry();
  const double angle = std::remainder(degrees, kFullCircle) * kPi / (kFullCircle / 2);
  const double c = std::abs(std::cos(angle));
  const double s = std::abs(std::sin(angle));
  MapGeometry geometry = old;
  geometry.width = roundedUp(c * old.width + s * old.height);
  geometry.height = roundedUp(s * old.width + c * old.height);
  const Point2 old_center = Point2(old.width, old.height) * (old.resolution / 2);
  const Point2 center = Point2(geometry.width, geometry.height) * (old.resolution / 2);
  // What was at the old centre, turned by `angle`, lies at the new centre.
  const Pose2 old_from_turned{old_center + Pose2{Point2::Zero(), -angle} * Point2(-center), -angle};
  geometry.map_from_image = old.map_from_image * old_from_turned;
  return resampledOn(geometry, map);
}

OccupancyMap resampled(const OccupancyMap& map, double resolution) {
  const MapGeometry& old = map.geometry();
  MapGeometry geometry = old;
  geometry.resolution = resolution;
  const double scale = old.resolution / resolution;
  if (!(scale > 0 && scale * std::max(old.width, old.height) < kMaxSide)) {
    throw MapError(MapErrorCode::kResolution,
                   "resolution is " + std::to_string(resolution) +
                       " m, must be positive and leave at most 1e6 pixels a side");
  }
  geometry.width = roundedUp(scale * old.width);
  geometry.height = roundedUp(scale * old.height);
  return resampledOn(geometry, map);
}

OccupancyMap noisy(const OccupancyMap& map, std::uint32_t seed) {
  OccupancyGrid grid;
  grid.geometry = map.geometry();
  RandomSource random(seed);
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    Occupancy occupancy = map.pixels()[i];
    if (occupancy == Occupancy::kFree) {
      const int draw = random.between(0, 999);
      const bool worn = touchesObstacle(map, grid.geometry.pixel(i));
      if (draw < (worn ? kWorn : kStray)) occupancy = Occupancy::kOccupied;
    }
    grid.values.push_back(valueOf(occupancy));
  }
  return OccupancyMap(grid);
}

std::vector<std::uint16_t> labelsOn(const MapGeometry& to, const MapGeometry& from,
                                    const std::vector<std::uint16_t>& labels) {
  if (labels.size() != from.pixelCount()) {
    throw std::invalid_argument("labels has " + std::to_string(labels.size()) +
                                " pixels, the map has " + std::to_string(from.pixelCount()));
  }
  std::vector<std::uint16_t> brought;
  brought.reserve(to.pixelCount());
  const PixelMap source(to, from);
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) {
      const auto i = source({x, y});
      brought.push_back(i ? labels[*i] : std::uint16_t{0});
    }
  }
  return brought;
}

}  // namespace agrid
