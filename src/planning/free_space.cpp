// SPDX-License-Identifier: BSD-3-Clause
#include "planning/free_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map/squared_distance.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
FreeSpace::FreeSpace(const MapGeometry& geometry,
                     std::shared_ptr<const SquaredDistances> squared_distances, double robot_radius)
    : geometry_(geometry),
      squared_distances_(std::move(squared_distances)),
      pages_(squared_distances_->pages()) {
  radius_px_ = std::round(robot_radius / geometry.resolution * 1e6) / 1e6;
  limit_ = static_cast<std::int32_t>(
      std::min(std::floor(radius_px_ * radius_px_), static_cast<double>(kFarSquared)));
}

FreeSpace FreeSpace::withDistances(
    std::shared_ptr<const SquaredDistances> squared_distances) const {
  FreeSpace other = *this;
  other.squared_distances_ = std::move(squared_distances);
  other.pages_ = other.squared_distances_->pages();
  return other;
}

FreeSpace FreeSpace::withKeepOut(std::shared_ptr<const KeepOut> keep_out) const {
  FreeSpace other = *this;
  other.keep_out_ = std::move(keep_out);
  return other;
}

FreeSpace FreeSpace::narrowedLess(double px) const {
  FreeSpace wider = *this;
  wider.keep_out_ = nullptr;
  wider.radius_px_ = radius_px_ - px;
  wider.limit_ =
      wider.radius_px_ < 0 ? -1 : static_cast<std::int32_t>(wider.radius_px_ * wider.radius_px_);
  return wider;
}

bool FreeSpace::canSee(FinePoint a, FinePoint b) const {
  return seesPastObstacles(a, b) && !(keep_out_ && keep_out_->isTouchedBy(a, b));
}

bool FreeSpace::seesPastObstacles(FinePoint a, FinePoint b) const {
  const SegmentRaster raster(a, b);
  const double columns_per_px = 1 / raster.stretch();
  for (int c = raster.first();;) {
    const SegmentRaster::Rows rows = raster.touched(c);
    for (int r = rows.low; r <= rows.high; ++r) {
      const Pixel p = raster.pixel(c, r);
      if (!isInside(p) || !isFarEnough(squaredDistance(p))) return false;
    }
    const int left = (raster.last() - c) * raster.step();
    if (left <= 0) return true;
    const double distance = std::sqrt(squaredDistance(raster.pixel(c, rows.low)));
    const double safe = (distance - radius_px_ - kTwoHalfDiagonals) * columns_per_px - 1;
    const int skipped = safe < 1 ? 0 : static_cast<int>(std::min(safe, 1e9));
    if (skipped >= left) {
      // The ring is no obstacle of the distances; the last column, checked, keeps it out for all.
      c = raster.last();
      continue;
    }
    c += (skipped + 1) * raster.step();
  }
}

}  // namespace agrid::planning
