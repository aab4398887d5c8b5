// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "agrid/semantic_map.h"
#include "planning/barriers.h"
#include "planning/free_space.h"
#include "planning/landmarks.h"
#include "planning/obstacle_field.h"
#include "planning/portal_graph.h"
#include "planning/region_labels.h"
#include "planning/roadmap.h"

namespace agrid::planning {

/// What is prepared once for a robot's radius. It depends on the metric map, the closed doors and
/// the pixels of forbidden areas alone: the areas' labels decide where it is divided.
struct RadiusRoads {
  using Field = std::shared_ptr<const ObstacleField>;

  /// All doors are open in `open_field`, and no area is forbidden.
  /// @throws Stopped
  RadiusRoads(const MapGeometry& geometry, Field open_field, double robot_radius,
              const PixelLabels& labels, const StopCheck& stop);
  /// `former` with other doors closed and other areas forbidden.
  /// @param base  prepared with all doors open and no area forbidden
  RadiusRoads(const RadiusRoads& former, const RadiusRoads& base, Field field_now,
              std::shared_ptr<const KeepOut> keep_out);

  /// All pixels that are free in one of the two and not in the other.
  std::vector<PixelBox> changedBoxes(const RadiusRoads& other) const;

  const Field field;
  const FreeSpace free;
  const Roadmap roadmap;
  const Landmarks path_landmarks;
  const Landmarks least_landmarks;
};

/// The pieces that the areas have for a radius; made when they are first asked for.
class AreaPieces {
 public:
  explicit AreaPieces(PixelLabels labels) : labels_(std::move(labels)) {}
  const PixelLabels& labels() const { return labels_; }
  /// Its classes are the labels. @throws Stopped
  const PortalGraph& graph(const FreeSpace& free, const StopCheck& stop) const;

 private:
  PixelLabels labels_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const PortalGraph> graph_;
};

/// What is prepared for a radius, as the areas and doors of one semantic map divide it.
class RadiusLevel {
 public:
  /// @param labels  those that the roads were prepared with
  RadiusLevel(std::shared_ptr<const RadiusRoads> prepared, PixelLabels labels);
  /// The same areas with other doors closed or other areas forbidden.
  /// @param former  of whose roads `prepared` was made
  RadiusLevel(const RadiusLevel& former, std::shared_ptr<const RadiusRoads> prepared);
  /// The same roads for a map with other areas or doors.
  /// @param same_doors  as to their places and to which of them are closed
  RadiusLevel(const RadiusLevel& former, PixelLabels labels, bool same_doors);

  const std::shared_ptr<const RadiusRoads> prepared;
  const FreeSpace& free;
  const Roadmap& roadmap;
  const Landmarks& path_landmarks;
  const Landmarks& least_landmarks;

  const RegionLabels& regionLabels() const { return *region_labels_; }
  const PixelLabels& labels() const { return pieces_->labels(); }

  /// What keeps its components apart.
  const Barriers& barriers() const { return *barriers_; }

  /// First level: its classes are the labels of the areas. Made when it is first asked for.
  const PortalGraph& areas(const StopCheck& stop) const { return pieces_->graph(free, stop); }

 private:
  std::shared_ptr<const RegionLabels> region_labels_;
  std::shared_ptr<const Barriers> barriers_;
  std::shared_ptr<const AreaPieces> pieces_;
};

}  // namespace agrid::planning
