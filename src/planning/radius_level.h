// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "agrid/semantic_map.h"
#include "planning/barriers.h"
#include "planning/free_space.h"
#include "planning/landmarks.h"
#include "planning/portal_graph.h"
#include "planning/roadmap.h"

namespace agrid::planning {

/// What is prepared once for a robot's radius.
class RadiusLevel {
 public:
  RadiusLevel(const SemanticMap& map, const FreeSpace& free_space, const StopCheck& stop);

  const FreeSpace free;
  const Roadmap roadmap;
  const Landmarks path_landmarks;
  const Landmarks least_landmarks;

  /// What keeps its components apart.
  const Barriers barriers;

  /// First level: its classes are the labels of the areas. Made when it is first asked for.
  const PortalGraph& areas(const StopCheck& stop) const;

 private:
  const SemanticMap& map_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const PortalGraph> areas_;
};

/// The levels of the last few radii.
class LevelCache {
 public:
  LevelCache(const SemanticMap& map,
             std::shared_ptr<const std::vector<std::int32_t>> squared_distances)
      : map_(map), squared_distances_(std::move(squared_distances)) {}

  /// Prepares a level outside of the lock, so that other radii are answered meanwhile.
  /// @throws Stopped
  std::shared_ptr<const RadiusLevel> get(double robot_radius, const StopCheck& stop);

 private:
  std::shared_ptr<const RadiusLevel> find(double radius_px);

  const SemanticMap& map_;
  std::shared_ptr<const std::vector<std::int32_t>> squared_distances_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<const RadiusLevel>> levels_;  ///< last used first
};

}  // namespace agrid::planning
