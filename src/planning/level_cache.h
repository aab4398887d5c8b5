// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "planning/radius_level.h"

namespace agrid::planning {

/// Which of the forbidden areas a robot may be in all the same: none, that of one label, or all.
using Entered = std::uint32_t;
constexpr Entered kNoneEntered = 0;
constexpr Entered kAllEntered = 0xffffffffU;

/// The levels of the last few radii.
class LevelCache {
 public:
  LevelCache(const MapGeometry& geometry, const AreaMap& areas, const Obstacles& obstacles);
  /// Takes over the levels of the same map with other areas, closed doors or forbidden areas.
  /// @param same_doors  as to their places and to which of them are closed
  LevelCache(const LevelCache& former, const AreaMap& areas, const Obstacles& obstacles,
             bool same_doors);

  /// Prepares a level outside of the lock, so that other radii are answered meanwhile.
  /// @throws Stopped
  std::shared_ptr<const RadiusLevel> get(double robot_radius, Entered entered,
                                         const StopCheck& stop);

  /// Null if no area is forbidden.
  const KeepOut* keepOut() const { return keep_out_.get(); }

 private:
  using Roads = std::shared_ptr<const RadiusRoads>;
  struct Entry {
    std::shared_ptr<const RadiusLevel> level;  ///< perhaps with other doors closed
    Roads base;                                ///< its roads with all doors open
    Entered entered = kNoneEntered;
    bool is_current = false;  ///< as to doors and forbidden areas
  };
  void keep(const Entry& entry);
  std::vector<Entry>::iterator find(double radius_px, Entered entered);
  std::optional<Entry> closest(double radius_px, Entered entered);
  std::vector<Entry> entries() const;
  Entry prepared(double robot_radius, const StopCheck& stop) const;
  Entry upToDate(const Entry& entry, Entered entered) const;
  std::shared_ptr<const KeepOut> keepOutBut(Entered entered) const;

  MapGeometry geometry_;
  PixelLabels labels_;
  RadiusRoads::Field open_;                  ///< all doors are open
  RadiusRoads::Field field_;                 ///< doors are as they are
  std::shared_ptr<const KeepOut> keep_out_;  ///< null: no area is forbidden
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;  ///< last used first
};

}  // namespace agrid::planning
