// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pixel_region.h"

#include <algorithm>
#include <cmath>

namespace agrid::planning {

void PixelRegion::reset(const MapGeometry& geometry) {
  if (geometry.pixelCount() == inside_.size()) {
    for (const std::size_t i : members_) inside_[i] = 0;
  } else {
    inside_.assign(geometry.pixelCount(), 0);
  }
  members_.clear();
  geometry_ = geometry;
}

void PixelRegion::addDisc(const Point2& center, double radius) {
  const int low = std::max(0, static_cast<int>(std::ceil(center.y() - radius)));
  const int high =
      std::min(geometry_.height - 1, static_cast<int>(std::floor(center.y() + radius)));
  for (int y = low; y <= high; ++y) {
    const double half =
        std::sqrt(std::max(0.0, radius * radius - (y - center.y()) * (y - center.y())));
    const int from = std::max(0, static_cast<int>(std::ceil(center.x() - half)));
    const int to = std::min(geometry_.width - 1, static_cast<int>(std::floor(center.x() + half)));
    for (int x = from; x <= to; ++x) {
      const std::size_t i = geometry_.index({x, y});
      if (inside_[i] != 0) continue;
      inside_[i] = 1;
      members_.push_back(i);
    }
  }
}

void PixelRegion::addBand(const Point2& a, const Point2& b, double radius) {
  const double step = std::max(radius / 2, 1.0);
  const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
  for (int i = 0; i <= steps; ++i) addDisc(a + (b - a) * i / steps, radius);
}

}  // namespace agrid::planning
