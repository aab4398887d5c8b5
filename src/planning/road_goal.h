// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/radius_level.h"
#include "planning/road_end.h"
#include "planning/target.h"

namespace agrid::planning {

/// A portal crossed into the region on one of its sides (as in Portal::nodes).
struct Crossing {
  std::uint32_t portal = 0;
  std::uint32_t side = 0;
};

/// Where ways over the portals end: at a point; in an area's regions as soon as they are entered;
/// or in regions that also hold other areas' pixels, on the borders between these and the area's.
class RoadGoal {
 public:
  /// An end of the roads within a region.
  struct End {
    RoadEnd road;
    const Portal* border;  ///< on which it is the middle; nullptr: the target's point
    float reach;           ///< of the border
  };
  /// A leg from a portal to the goal.
  struct Leg {
    float length = kUnreachable;
    End* end = nullptr;  ///< nullptr: the goal begins at the portal
  };

  /// @param target  must outlive the object
  RoadGoal(const RadiusLevel& level, const Target& target);

  const Target& target() const { return target_; }
  /// In which ways end.
  const std::vector<std::uint32_t>& regions() const { return regions_; }
  bool endsIn(std::uint32_t region) const;
  std::vector<End*> endsOf(std::uint32_t region);

  /// From a portal to the goal in the region that is entered: no path there is shorter than the
  /// straight line ...
  float straightLeg(Measure measure, const Crossing& crossing) const;
  /// ... nor, as far as has been looked, than this [px].
  float hopedLeg(Measure measure, const Crossing& crossing) const;
  /// The shortest one.
  Leg leg(Measure measure, const Crossing& crossing);

  /// A pixel's centre in the target's area that lies beside a border and is near `from`.
  /// @param portal  a portal, or a border within a region
  /// @param first  a pixel of it, which the area has
  FinePoint placeBeside(const Portal& portal, Pixel first, FinePoint from) const;

 private:
  struct Range {
    std::uint32_t region;
    std::size_t first;
    std::size_t last;
  };
  const Range* rangeOf(std::uint32_t region) const;
  std::uint32_t regionOf(const Crossing& crossing) const;
  bool isOfArea(Pixel p) const;
  bool isAreaBeyond(Measure measure, const Crossing& crossing) const;
  template <typename LengthOf>
  float leastOf(Measure measure, const Crossing& crossing, const LengthOf& lengthOf) const;

  const RadiusLevel& level_;
  const Target& target_;
  std::vector<std::uint32_t> regions_;
  std::vector<End> ends_;
  std::vector<Range> ranges_;  ///< of ends_, by region
};

}  // namespace agrid::planning
