// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_goal.h"

#include <algorithm>

namespace agrid::planning {
namespace {

/// A way to anywhere on a border may be shorter than to its middle.
float slackOf(Measure measure, const RoadGoal::End& end) {
  return measure == Measure::kLeast ? end.reach : 0;
}

}  // namespace

RoadGoal::RoadGoal(const RadiusLevel& level, const Target& target)
    : level_(level), target_(target), regions_(target.regions) {
  if (target.point) {
    const std::uint32_t region = target.regions.front();
    ends_.push_back({RoadEnd(level.free, level.roadmap, *target.point, region), nullptr, 0});
    ranges_.push_back({region, 0, 1});
  }
  for (const TargetPart& part : target.parts) {
    const std::size_t first = ends_.size();
    for (const Portal& border : part.parts->borders) {
      if (border.nodes[0] != target.label && border.nodes[1] != target.label) continue;
      ends_.push_back({RoadEnd(level.free, level.roadmap, border.crossing(), part.region), &border,
                       static_cast<float>(border.reach)});
    }
    ranges_.push_back({part.region, first, ends_.size()});
    regions_.push_back(part.region);
  }
  std::sort(regions_.begin(), regions_.end());
}

bool RoadGoal::endsIn(std::uint32_t region) const {
  return std::binary_search(regions_.begin(), regions_.end(), region);
}

const RoadGoal::Range* RoadGoal::rangeOf(std::uint32_t region) const {
  const auto found =
      std::lower_bound(ranges_.begin(), ranges_.end(), region,
                       [](const Range& range, std::uint32_t r) { return range.region < r; });
  return found == ranges_.end() || found->region != region ? nullptr : &*found;
}

std::vector<RoadGoal::End*> RoadGoal::endsOf(std::uint32_t region) {
  std::vector<End*> ends;
  const Range* range = rangeOf(region);
  for (std::size_t i = range ? range->first : 0; range && i < range->last; ++i) {
    ends.push_back(&ends_[i]);
  }
  return ends;
}

std::uint32_t RoadGoal::regionOf(const Crossing& crossing) const {
  return level_.roadmap.regions().portals()[crossing.portal].nodes[crossing.side];
}

bool RoadGoal::isOfArea(Pixel p) const {
  return level_.labels()[level_.free.geometry().index(p)] == target_.label;
}

/// Whether the area begins at a portal of a region of which it has a part: by the path through its
/// middle, or anywhere on its border.
bool RoadGoal::isAreaBeyond(Measure measure, const Crossing& crossing) const {
  if (target_.point) return false;
  const PortalGraph& regions = level_.roadmap.regions();
  const Portal& portal = regions.portals()[crossing.portal];
  if (measure == Measure::kPath) {
    return isOfArea(crossing.side == 0 ? portal.middle : portal.beyond);
  }
  for (int y = portal.box.low.y; y <= portal.box.high.y; ++y) {
    for (int x = portal.box.low.x; x <= portal.box.high.x; ++x) {
      const std::size_t i = level_.free.geometry().index({x, y});
      if (regions.nodeAt(i) == portal.nodes[crossing.side] && isOfArea({x, y})) return true;
    }
  }
  return false;
}

/// @param lengthOf  of an end and the portal's place among those of the region
template <typename LengthOf>
float RoadGoal::leastOf(Measure measure, const Crossing& crossing, const LengthOf& lengthOf) const {
  const Range* range = rangeOf(regionOf(crossing));
  if (!range || isAreaBeyond(measure, crossing)) return 0;
  const std::size_t rank = level_.roadmap.rankOf(crossing.portal, crossing.side);
  float least = kUnreachable;
  for (std::size_t i = range->first; i < range->last; ++i) {
    least = std::min(least, lengthOf(ends_[i].road, rank) - slackOf(measure, ends_[i]));
  }
  return std::max(least, 0.0F);
}

float RoadGoal::straightLeg(Measure measure, const Crossing& crossing) const {
  return leastOf(measure, crossing, [&](const RoadEnd& end, std::size_t rank) {
    return end.straightLength(measure, rank);
  });
}

float RoadGoal::hopedLeg(Measure measure, const Crossing& crossing) const {
  return leastOf(measure, crossing, [&](const RoadEnd& end, std::size_t rank) {
    return end.hopedLength(measure, rank);
  });
}

RoadGoal::Leg RoadGoal::leg(Measure measure, const Crossing& crossing) {
  const std::uint32_t region = regionOf(crossing);
  if (!rangeOf(region) || isAreaBeyond(measure, crossing)) return {0, nullptr};
  const std::size_t rank = level_.roadmap.rankOf(crossing.portal, crossing.side);
  Leg best;
  for (End* end : endsOf(region)) {
    const float slack = slackOf(measure, *end);
    if (!(end->road.hopedLength(measure, rank) - slack < best.length)) continue;
    const float length = end->road.length(measure, rank) - slack;
    if (length < best.length) best = {length, end};
  }
  best.length = std::max(best.length, 0.0F);
  return best;
}

FinePoint RoadGoal::placeBeside(const Portal& portal, Pixel first, FinePoint from) const {
  const MapGeometry& geometry = level_.free.geometry();
  const PortalGraph& regions = level_.roadmap.regions();
  const std::uint32_t region = regions.nodeAt(geometry.index(first));
  FinePoint nearest = centerOf(first);
  for (int y = portal.box.low.y; y <= portal.box.high.y; ++y) {
    for (int x = portal.box.low.x; x <= portal.box.high.x; ++x) {
      if (regions.nodeAt(geometry.index({x, y})) != region || !isOfArea({x, y})) continue;
      const FinePoint inside = centerOf({x, y});
      if (distancePx(inside, from) < distancePx(nearest, from) &&
          level_.free.canSee(portal.crossing(), inside)) {
        nearest = inside;
      }
    }
  }
  return nearest;
}

}  // namespace agrid::planning
