// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/roadmap.h"

namespace agrid::planning {

/// How a point is connected with the roads of its region. Sight is looked for when it is asked for,
/// since few of the region's turning points matter to a search.
class RoadEnd {
 public:
  using Node = RegionRoads::Node;

  /// @param region  of `point`
  RoadEnd(const FreeSpace& free, const Roadmap& roadmap, FinePoint point, std::uint32_t region);

  FinePoint point() const { return point_; }
  std::uint32_t region() const { return region_; }
  const RegionRoads& roads() const { return *roads_; }

  /// To a portal of the region: no path is shorter than the straight line ...
  float straightLength(Measure measure, std::size_t rank) const;
  /// ... nor, as far as has been looked, than this [px].
  float hopedLength(Measure measure, std::size_t rank) const;
  /// Of the shortest path to a portal; kUnreachable if there is none within the region [px].
  float length(Measure measure, std::size_t rank);
  /// The node after the point on the path to the middle of a portal.
  Node next(std::size_t rank);

  /// Distance to a turning point around which a shortest path can go on, if nothing is in between;
  /// kUnreachable if it is known that none can [px].
  float hopedSight(Node node) const { return near_[node]; }
  bool canSee(Node node);

 private:
  enum class Sight : std::uint8_t { kUnknown, kSeen, kHidden };
  struct Choice {
    float length;
    Node node;
  };
  bool seesPortal(Measure measure, std::size_t rank);
  Choice hopedChoice(Measure measure, std::size_t rank) const;
  Choice choice(Measure measure, std::size_t rank);

  const FreeSpace& free_;
  const PortalGraph& regions_;
  FinePoint point_;
  std::uint32_t region_;
  const RegionRoads* roads_;
  std::vector<float> near_;   ///< hopedSight
  std::vector<Sight> sight_;  ///< of the turning points, then of the portals by either measure
};

}  // namespace agrid::planning
