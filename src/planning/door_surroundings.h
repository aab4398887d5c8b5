// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "agrid/areas/area_map.h"
#include "planning/obstacles.h"
#include "planning/portal_graph.h"

namespace agrid::planning {

class RadiusLevel;

/// Which components of free space each door keeps apart, found in the pixels around it.
class DoorSurroundings {
 public:
  /// The arguments must outlive the object.
  DoorSurroundings(const std::vector<Door>& doors, const RadiusLevel& level,
                   const Obstacles& obstacles);

  /// Exactly the groups of components that would be one if a closed door were open; none if the
  /// door is not closed, or if its opening lets the robot through nowhere.
  std::vector<std::vector<std::uint32_t>> joinedWhenOpen(std::size_t door) const;

  /// The components first met on both sides of a door when one walks away from its jambs where no
  /// obstacle is, however narrow; none if the robot can stand in the door. Sorted.
  std::vector<std::uint32_t> joinedWhenWider(std::size_t door) const;

 private:
  bool isShutByAnother(std::size_t pixel_index, std::size_t door) const;
  std::uint32_t componentAt(Pixel p) const;
  std::vector<bool> freedBy(std::size_t door, const PixelBox& box) const;

  const std::vector<Door>& doors_;
  const RadiusLevel& level_;
  const Obstacles& obstacles_;
  std::vector<std::pair<std::size_t, std::size_t>> shut_;  ///< pixel and closed door, sorted
};

}  // namespace agrid::planning
