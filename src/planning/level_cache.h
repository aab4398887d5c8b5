// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "planning/radius_level.h"

namespace agrid::planning {

/// The levels of the last few radii.
class LevelCache {
 public:
  using Distances = std::shared_ptr<const std::vector<std::int32_t>>;

  LevelCache(const MapGeometry& geometry, PixelLabels labels, Distances squared_distances);
  /// Takes over the levels of the same map with other areas, as far as their regions fit in.
  /// @param same_doors  as to their places and to which of them are closed
  LevelCache(const LevelCache& former, PixelLabels labels, bool same_doors);

  /// Prepares a level outside of the lock, so that other radii are answered meanwhile.
  /// @throws Stopped
  std::shared_ptr<const RadiusLevel> get(double robot_radius, const StopCheck& stop);

 private:
  using Levels = std::vector<std::shared_ptr<const RadiusLevel>>;
  std::shared_ptr<const RadiusLevel> find(double radius_px);
  Levels levels() const;

  MapGeometry geometry_;
  PixelLabels labels_;
  Distances squared_distances_;
  mutable std::mutex mutex_;
  Levels levels_;  ///< last used first
};

}  // namespace agrid::planning
