// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "agrid/map/paged_array.h"
#include "planning/free_space.h"
#include "planning/lazy_roads.h"
#include "planning/portal_graph.h"
#include "planning/portal_graph_patch.h"
#include "planning/region_classes.h"
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
  Roadmap(const FreeSpace& free, const PixelLabels& pixel_labels, const StopCheck& stop);

  /// Where pixels became free or are no longer.
  struct Change {
    const FreeSpace& free;                   ///< as it is now
    const std::vector<PixelBox>& boxes;      ///< all pixels nearer or farther than before ...
    const std::vector<PixelBox>& from_base;  ///< ... and than in the base
  };
  /// `former` after a change: what lies far from it is shared, the roads near it are made when they
  /// are asked for.
  /// @param base  of the same map with more free pixels than either; its numbers and roads come
  ///              back where all is as there
  Roadmap(const Roadmap& former, const Roadmap& base, const Change& change);

  const PortalGraph& regions() const { return *regions_; }
  /// What is not as in the roadmap that this one was made from: regions that are new or gone, and
  /// portals that are new.
  const RenewedNodes& renewedRegions() const { return renewed_regions_; }
  const std::set<std::uint32_t>& newPortals() const { return new_portals_; }
  const RegionRoads& roads(std::uint32_t region) const { return roads_[region]->get(); }
  /// Which of a region's portals a portal is; `side` is the region's place in Portal::nodes.
  std::uint32_t rankOf(std::uint32_t portal, std::size_t side) const {
    return rank_[2 * std::size_t{portal} + side];
  }
  /// Calls `visit(other, length)` for the other portals of the region on one side of a portal that
  /// can be reached through it.
  template <typename Visit>
  void forEachOnwards(Measure measure, std::uint32_t portal, std::size_t side,
                      const Visit& visit) const {
    const std::uint32_t region = regions_->portals()[portal].nodes[side];
    const RegionRoads& roads = this->roads(region);
    const float* lengths = roads.lengthsTo(measure, rankOf(portal, side)) + roads.points().size();
    for (const std::uint32_t other : regions_->portalsOf(region)) {
      const float length = *lengths++;
      if (other != portal && length < kUnreachable) visit(other, length);
    }
  }

 private:
  Roadmap(const FreeSpace& free, const PixelLabels& pixel_labels,
          const std::vector<TurningPoint>& points, const StopCheck& stop);
  void rankPortals();
  void rankPortalsOf(std::uint32_t region);
  void renewRoads(const Roadmap& base, const Change& change,
                  const std::set<std::uint32_t>& relisted);
  std::function<RegionRoads()> renewal(std::uint32_t region, const Roadmap& base,
                                       const Change& change) const;
  void buildRoads(const FreeSpace& free, const std::vector<TurningPoint>& points,
                  const StopCheck& stop);

  std::shared_ptr<const RegionClasses> classes_;
  std::shared_ptr<const PortalGraph> regions_;
  PagedArray<std::uint32_t, 6> rank_;
  PagedArray<std::shared_ptr<const LazyRoads>, 4> roads_;
  RenewedNodes renewed_regions_;
  std::set<std::uint32_t> new_portals_;
};

}  // namespace agrid::planning
