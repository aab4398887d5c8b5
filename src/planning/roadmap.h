// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/free_space.h"
#include "planning/portal_graph.h"
#include "planning/region_roads.h"
#include "planning/stop.h"

namespace agrid::planning {

/// Shortest paths prepared for one radius: free space divided into regions (pieces of the areas),
/// the portals between them, and the roads within each. A path crosses a portal somewhere along its
/// border; the roads lead to the border's middle.
class Roadmap {
 public:
  /// @param pixel_labels  of the areas, row-major, 0 where there is none
  /// @throws Stopped
  Roadmap(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
          const StopCheck& stop);

  const PortalGraph& regions() const { return regions_; }
  const RegionRoads& roads(std::uint32_t region) const { return roads_[region]; }
  /// Which of a region's portals a portal is; `side` is the region's place in Portal::nodes.
  std::uint32_t rankOf(std::uint32_t portal, std::size_t side) const {
    return rank_[2 * std::size_t{portal} + side];
  }
  /// Calls `visit(other, length)` for the other portals of the region on one side of a portal that
  /// can be reached through it.
  template <typename Visit>
  void forEachOnwards(Measure measure, std::uint32_t portal, std::size_t side,
                      const Visit& visit) const {
    const std::uint32_t region = regions_.portals()[portal].nodes[side];
    const RegionRoads& roads = roads_[region];
    const float* lengths = roads.lengthsTo(measure, rankOf(portal, side)) + roads.points().size();
    for (const std::uint32_t other : regions_.portalsOf(region)) {
      const float length = *lengths++;
      if (other != portal && length < kUnreachable) visit(other, length);
    }
  }

 private:
  Roadmap(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
          const std::vector<TurningPoint>& points, const StopCheck& stop);
  void rankPortals();
  void buildRoads(const FreeSpace& free, const std::vector<TurningPoint>& points,
                  const StopCheck& stop);

  PortalGraph regions_;
  std::vector<std::uint32_t> rank_;
  std::vector<RegionRoads> roads_;
};

}  // namespace agrid::planning
