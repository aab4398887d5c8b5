// SPDX-License-Identifier: BSD-3-Clause
#include "planning/level_cache.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {
namespace {

constexpr std::size_t kMaxLevels = 4;

}  // namespace

LevelCache::LevelCache(const MapGeometry& geometry, PixelLabels labels, Distances squared_distances)
    : geometry_(geometry),
      labels_(std::move(labels)),
      squared_distances_(std::move(squared_distances)) {}

LevelCache::LevelCache(const LevelCache& former, PixelLabels labels, bool same_doors)
    : geometry_(former.geometry_),
      labels_(std::move(labels)),
      squared_distances_(former.squared_distances_) {
  for (const auto& level : former.levels()) {
    auto label_of = level->labelsOfRegions(labels_);
    if (!label_of) continue;
    levels_.push_back(
        std::make_shared<const RadiusLevel>(*level, labels_, std::move(label_of), same_doors));
  }
}

LevelCache::Levels LevelCache::levels() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return levels_;
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
  const FreeSpace free(geometry_, squared_distances_, robot_radius);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (auto level = find(free.radiusPx())) return level;
  }
  auto level = std::make_shared<const RadiusLevel>(
      std::make_shared<const RadiusRoads>(free, labels_, stop), labels_);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (auto other = find(free.radiusPx())) return other;
  levels_.insert(levels_.begin(), level);
  if (levels_.size() > kMaxLevels) levels_.pop_back();
  return level;
}

}  // namespace agrid::planning
