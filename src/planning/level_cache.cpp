// SPDX-License-Identifier: BSD-3-Clause
#include "planning/level_cache.h"

#include <algorithm>
#include <set>
#include <utility>

namespace agrid::planning {
namespace {

constexpr std::size_t kMaxRadii = 4;

}  // namespace

LevelCache::LevelCache(const MapGeometry& geometry, const AreaMap& areas,
                       const Obstacles& obstacles)
    : geometry_(geometry),
      labels_(areas.pixel_labels),
      open_(std::make_shared<const ObstacleField>(geometry, obstacles)),
      field_(ObstacleField::closedAs(open_, obstacles)),
      keep_out_(KeepOut::of(areas, geometry, nullptr)) {}

/// What was entered is named by labels of the former areas: such levels are not taken over.
LevelCache::LevelCache(const LevelCache& former, const AreaMap& areas, const Obstacles& obstacles,
                       bool same_doors)
    : geometry_(former.geometry_),
      labels_(areas.pixel_labels),
      open_(former.open_),
      field_(ObstacleField::closedAs(former.field_, obstacles)),
      keep_out_(KeepOut::of(areas, geometry_, former.keep_out_)) {
  for (const Entry& entry : former.entries()) {
    if (entry.entered != kNoneEntered) continue;
    const bool is_current =
        entry.is_current && former.field_ == field_ && former.keep_out_ == keep_out_;
    entries_.push_back({std::make_shared<const RadiusLevel>(*entry.level, labels_, same_doors),
                        entry.base, kNoneEntered, is_current});
  }
}

std::vector<LevelCache::Entry> LevelCache::entries() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_;
}

std::vector<LevelCache::Entry>::iterator LevelCache::find(double radius_px, Entered entered) {
  return std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.level->free.radiusPx() == radius_px && entry.entered == entered;
  });
}

/// For the radius, and as was entered if there is such a level.
std::optional<LevelCache::Entry> LevelCache::closest(double radius_px, Entered entered) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto found = find(radius_px, entered);
  if (found == entries_.end()) {
    found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.level->free.radiusPx() == radius_px;
    });
  }
  if (found == entries_.end()) return std::nullopt;
  std::rotate(entries_.begin(), found, found + 1);
  return entries_.front();
}

LevelCache::Entry LevelCache::prepared(double robot_radius, const StopCheck& stop) const {
  Entry entry;
  entry.base = std::make_shared<const RadiusRoads>(geometry_, open_, robot_radius, labels_, stop);
  entry.level = std::make_shared<const RadiusLevel>(entry.base, labels_);
  return entry;
}

std::shared_ptr<const KeepOut> LevelCache::keepOutBut(Entered entered) const {
  if (!keep_out_ || entered == kAllEntered) return nullptr;
  return entered == kNoneEntered ? keep_out_
                                 : keep_out_->without(static_cast<std::uint16_t>(entered));
}

LevelCache::Entry LevelCache::upToDate(const Entry& entry, Entered entered) const {
  const RadiusRoads& roads = *entry.level->prepared;
  std::shared_ptr<const KeepOut> keep_out = keepOutBut(entered);
  if (roads.field->changedBoxes(*field_).empty() &&
      KeepOut::changedBoxes(roads.free.keepOut().get(), keep_out.get()).empty()) {
    return {entry.level, entry.base, entered, true};
  }
  auto changed =
      std::make_shared<const RadiusRoads>(roads, *entry.base, field_, std::move(keep_out));
  return {std::make_shared<const RadiusLevel>(*entry.level, std::move(changed)), entry.base,
          entered, true};
}

std::shared_ptr<const RadiusLevel> LevelCache::get(double robot_radius, Entered entered,
                                                   const StopCheck& stop) {
  if (!keep_out_) entered = kNoneEntered;
  const double radius_px = FreeSpace(geometry_, field_->distances(), robot_radius).radiusPx();
  std::optional<Entry> entry = closest(radius_px, entered);
  if (entry && entry->entered == entered && entry->is_current) return entry->level;
  entry = upToDate(entry ? *entry : prepared(robot_radius, stop), entered);
  const std::lock_guard<std::mutex> lock(mutex_);
  keep(*entry);
  return entry->level;
}

/// Levels of one base share most of what they hold: a radius keeps the usual one, one in which all
/// may be entered, and one in which one area may.
void LevelCache::keep(const Entry& entry) {
  const auto isReplaced = [&](const Entry& other) {
    if (other.level->free.radiusPx() != entry.level->free.radiusPx()) return false;
    const bool is_usual = other.entered == kNoneEntered || other.entered == kAllEntered;
    return other.entered == entry.entered || !is_usual;
  };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), isReplaced), entries_.end());
  entries_.insert(entries_.begin(), entry);
  const auto radii = [&] {
    std::set<double> different;
    for (const Entry& other : entries_) different.insert(other.level->free.radiusPx());
    return different.size();
  };
  while (radii() > kMaxRadii) entries_.pop_back();
}

}  // namespace agrid::planning
