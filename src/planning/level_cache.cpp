// SPDX-License-Identifier: BSD-3-Clause
#include "planning/level_cache.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {
namespace {

constexpr std::size_t kMaxLevels = 4;

}  // namespace

LevelCache::LevelCache(const MapGeometry& geometry, PixelLabels labels, const Obstacles& obstacles)
    : geometry_(geometry),
      labels_(std::move(labels)),
      open_(std::make_shared<const ObstacleField>(geometry, obstacles)),
      field_(ObstacleField::closedAs(open_, obstacles)) {}

LevelCache::LevelCache(const LevelCache& former, PixelLabels labels, const Obstacles& obstacles,
                       bool same_doors)
    : geometry_(former.geometry_),
      labels_(std::move(labels)),
      open_(former.open_),
      field_(ObstacleField::closedAs(former.field_, obstacles)) {
  for (const Entry& entry : former.entries()) {
    entries_.push_back({std::make_shared<const RadiusLevel>(*entry.level, labels_, same_doors),
                        entry.base, entry.field});
  }
}

std::vector<LevelCache::Entry> LevelCache::entries() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_;
}

std::optional<LevelCache::Entry> LevelCache::find(double radius_px) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.level->free.radiusPx() == radius_px;
  });
  if (found == entries_.end()) return std::nullopt;
  std::rotate(entries_.begin(), found, found + 1);
  return entries_.front();
}

LevelCache::Entry LevelCache::prepared(double robot_radius, const StopCheck& stop) const {
  Entry entry;
  entry.base = std::make_shared<const RadiusRoads>(geometry_, open_, robot_radius, labels_, stop);
  entry.level = std::make_shared<const RadiusLevel>(entry.base, labels_);
  entry.field = open_;
  return withDoors(entry);
}

LevelCache::Entry LevelCache::withDoors(const Entry& entry) const {
  const RadiusRoads& roads = *entry.level->prepared;
  if (roads.field->changedBoxes(*field_).empty()) return {entry.level, entry.base, field_};
  auto changed = std::make_shared<const RadiusRoads>(roads, *entry.base, field_);
  return {std::make_shared<const RadiusLevel>(*entry.level, std::move(changed)), entry.base,
          field_};
}

std::shared_ptr<const RadiusLevel> LevelCache::get(double robot_radius, const StopCheck& stop) {
  const double radius_px = FreeSpace(geometry_, field_->distances(), robot_radius).radiusPx();
  std::optional<Entry> entry;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    entry = find(radius_px);
  }
  if (entry && entry->field == field_) return entry->level;
  entry = entry ? withDoors(*entry) : prepared(robot_radius, stop);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!find(radius_px)) entries_.insert(entries_.begin(), *entry);
  entries_.front() = *entry;
  if (entries_.size() > kMaxLevels) entries_.pop_back();
  return entry->level;
}

}  // namespace agrid::planning
