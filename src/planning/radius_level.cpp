// SPDX-License-Identifier: BSD-3-Clause
#include "planning/radius_level.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {
namespace {

/// Each takes 4 to 8 bytes a pixel.
constexpr std::size_t kMaxLevels = 4;

}  // namespace

RadiusLevel::RadiusLevel(const SemanticMap& map, const FreeSpace& free_space, const StopCheck& stop)
    : free(free_space),
      roadmap(free_space, map.area_map.pixel_labels, stop),
      path_landmarks(roadmap, Measure::kPath, stop),
      least_landmarks(roadmap, Measure::kLeast, stop),
      map_(map) {}

const PortalGraph& RadiusLevel::areas(const StopCheck& stop) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!areas_) {
    const auto& labels = map_.area_map.pixel_labels;
    const auto labels_of_row = [&](int y, std::vector<std::uint32_t>& row) {
      const std::size_t first = static_cast<std::size_t>(y) * row.size();
      for (std::size_t x = 0; x < row.size(); ++x) row[x] = labels[first + x];
    };
    areas_ = std::make_unique<const PortalGraph>(free, labels_of_row, stop);
  }
  return *areas_;
}

std::shared_ptr<const RadiusLevel> LevelCache::find(double radius_px) {
  const auto found = std::find_if(levels_.begin(), levels_.end(), [&](const auto& level) {
    return level->free.radiusPx() == radius_px;
  });
  if (found == levels_.end()) return nullptr;
  std::rotate(levels_.begin(), found, found + 1);
  return levels_.front();
}

std::shared_ptr<const RadiusLevel> LevelCache::get(double robot_radius, const StopCheck& stop) {
  const FreeSpace free(map_.map().geometry(), squared_distances_, robot_radius);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (auto level = find(free.radiusPx())) return level;
  }
  auto level = std::make_shared<const RadiusLevel>(map_, free, stop);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (auto other = find(free.radiusPx())) return other;
  levels_.insert(levels_.begin(), level);
  if (levels_.size() > kMaxLevels) levels_.pop_back();
  return level;
}

}  // namespace agrid::planning
