// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "planning/radius_level.h"

namespace agrid::planning {

/// The levels of the last few radii.
class LevelCache {
 public:
  LevelCache(const MapGeometry& geometry, PixelLabels labels, const Obstacles& obstacles);
  /// Takes over the levels of the same map with other areas and other closed doors.
  /// @param same_doors  as to their places and to which of them are closed
  LevelCache(const LevelCache& former, PixelLabels labels, const Obstacles& obstacles,
             bool same_doors);

  /// Prepares a level outside of the lock, so that other radii are answered meanwhile.
  /// @throws Stopped
  std::shared_ptr<const RadiusLevel> get(double robot_radius, const StopCheck& stop);

 private:
  using Roads = std::shared_ptr<const RadiusRoads>;
  struct Entry {
    std::shared_ptr<const RadiusLevel> level;  ///< perhaps with other doors closed
    Roads base;                                ///< its roads with all doors open
    RadiusRoads::Field field;                  ///< the doors that it was made for
  };
  std::optional<Entry> find(double radius_px);
  std::vector<Entry> entries() const;
  Entry prepared(double robot_radius, const StopCheck& stop) const;
  Entry withDoors(const Entry& entry) const;

  MapGeometry geometry_;
  PixelLabels labels_;
  RadiusRoads::Field open_;   ///< all doors are open
  RadiusRoads::Field field_;  ///< doors are as they are
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;  ///< last used first
};

}  // namespace agrid::planning
