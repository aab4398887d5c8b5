// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/planning/planner.h"
#include "planning/stop.h"

namespace agrid::planning {

/// What a robot must keep away from: pixels that are not free (unknown ones unless allowed) and
/// closed doors.
class Obstacles {
 public:
  /// @param clearance  the rule by which distances to them are measured
  Obstacles(const SemanticMap& map, bool allow_unknown, Clearance clearance = Clearance::kCostmap);

  Clearance clearance() const { return clearance_; }

  bool at(std::size_t pixel_index) const;
  /// The same with all doors open.
  bool blockedInMap(std::size_t pixel_index) const;
  /// The pixels that a door blocks when it is closed; some of them may be obstacles anyway.
  std::vector<std::size_t> pixelsOf(const Segment& jambs_map) const;
  /// The pixels of each closed door, sorted; the doors sorted, too, each once.
  const std::vector<std::vector<std::size_t>>& closedDoors() const { return closed_doors_; }
  /// One byte a pixel, row-major, 1 = obstacle.
  std::vector<std::uint8_t> mask() const;
  /// The same with all doors open.
  std::vector<std::uint8_t> openMask() const;

 private:
  const OccupancyMap* map_;
  bool allow_unknown_;
  Clearance clearance_;
  std::vector<std::vector<std::size_t>> closed_doors_;
  std::vector<std::size_t> door_pixels_;  // those of closed doors that are free in the map, sorted
};

/// Squared distance of every pixel to the marked ones [px^2], by the rule of `clearance`.
std::vector<std::int32_t> distancesToMarked(const MapGeometry& geometry,
                                            std::vector<std::uint8_t> marked, Clearance clearance,
                                            const StopCheck& stop = {});

/// Squared distance of every pixel to the obstacles [px^2], by the rule of `clearance`: from centre
/// to centre, or between the pixels' squares.
std::vector<std::int32_t> obstacleDistances(const MapGeometry& geometry, const Obstacles& obstacles,
                                            Clearance clearance, const StopCheck& stop = {});

}  // namespace agrid::planning
