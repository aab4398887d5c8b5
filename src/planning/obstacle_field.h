// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "planning/free_space.h"
#include "planning/obstacles.h"
#include "planning/portal.h"

namespace agrid::planning {

/// Squared distances to the obstacles, and the closed doors that are among them. A door changes
/// them only where it is nearer than all that the map itself has.
class ObstacleField {
 public:
  /// All doors are open, whatever `obstacles` says of them.
  ObstacleField(const MapGeometry& geometry, const Obstacles& obstacles);

  const std::shared_ptr<const SquaredDistances>& distances() const { return distances_; }

  /// The same map with those doors closed that `obstacles` says; pages without changes are shared.
  static std::shared_ptr<const ObstacleField> closedAs(
      const std::shared_ptr<const ObstacleField>& former, const Obstacles& obstacles);

  /// Of each door that is closed in one of the two and not in the other.
  std::vector<PixelBox> changedBoxes(const ObstacleField& other) const;

 private:
  struct ClosedDoor {
    std::vector<std::size_t> pixels;  ///< sorted
    PixelBox box;                     ///< of them
    PixelBox reach;                   ///< no pixel beyond is nearer to them than to the map's
  };
  static bool isBefore(const ClosedDoor& a, const ClosedDoor& b) { return a.pixels < b.pixels; }
  /// Squared distances to a door's pixels within `window`, row-major.
  std::vector<std::int32_t> distancesTo(const ClosedDoor& door, const PixelBox& window) const;
  /// Whether a door is nearest to no pixel beyond a window, of whose distances these are.
  bool endsWithin(const PixelBox& window, const std::vector<std::int32_t>& squared) const;
  void close(ClosedDoor door);
  void open(const ClosedDoor& door);
  void write(const PixelBox& window, const std::vector<std::int32_t>& squared);

  MapGeometry geometry_;
  Clearance clearance_;
  std::shared_ptr<const SquaredDistances> open_;  ///< with all doors open
  std::shared_ptr<const SquaredDistances> distances_;
  std::shared_ptr<SquaredDistances> changing_;  ///< distances_, while this is made
  std::vector<ClosedDoor> closed_;              ///< sorted by their pixels
};

}  // namespace agrid::planning
