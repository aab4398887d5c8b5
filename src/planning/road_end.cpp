// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_end.h"

#include <algorithm>
#include <array>

namespace agrid::planning {
namespace {

/// Smallest sum of two entries at the same place; in lanes, so that it is computed several at once.
float smallestSum(const float* a, const float* b, std::size_t count) {
  constexpr std::size_t kLanes = 8;
  std::array<float, kLanes> least;
  least.fill(kUnreachable);
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float sum = a[i + k] + b[i + k];
      least[k] = sum < least[k] ? sum : least[k];
    }
  }
  for (; i < count; ++i) least[0] = std::min(least[0], a[i] + b[i]);
  return *std::min_element(least.begin(), least.end());
}

}  // namespace

RoadEnd::RoadEnd(const FreeSpace& free, const Roadmap& roadmap, FinePoint point,
                 std::uint32_t region)
    : free_(free),
      regions_(roadmap.regions()),
      point_(point),
      region_(region),
      roads_(&roadmap.roads(region)) {
  near_.reserve(roads_->points().size());
  for (const TurningPoint& p : roads_->points()) {
    near_.push_back(p.isTangentTo(point) ? static_cast<float>(distancePx(p.corner(), point))
                                         : kUnreachable);
  }
  sight_.resize(near_.size() + 2 * roads_->portalCount(), Sight::kUnknown);
}

float RoadEnd::straightLength(Measure measure, std::size_t rank) const {
  const Portal& portal = regions_.portals()[regions_.portalsOf(region_).begin()[rank]];
  return static_cast<float>(measure == Measure::kPath ? distancePx(point_, portal.crossing())
                                                      : portal.distanceToBorder(point_));
}

bool RoadEnd::canSee(Node node) {
  Sight& sight = sight_[node];
  if (sight == Sight::kUnknown) {
    sight = free_.canSee(point_, roads_->at(node)) ? Sight::kSeen : Sight::kHidden;
    if (sight == Sight::kHidden) near_[node] = kUnreachable;
  }
  return sight == Sight::kSeen;
}

bool RoadEnd::seesPortal(Measure measure, std::size_t rank) {
  const std::size_t place = near_.size() + 2 * rank + (measure == Measure::kPath ? 0 : 1);
  if (sight_[place] == Sight::kUnknown) {
    const Portal& portal = regions_.portals()[regions_.portalsOf(region_).begin()[rank]];
    const bool seen = measure == Measure::kPath
                          ? free_.canSee(point_, portal.crossing())
                          : seesPortal(Measure::kPath, rank) ||
                                free_.narrowedLess(portal.reach + kTwoHalfDiagonals)
                                    .canSee(point_, portal.crossing());
    sight_[place] = seen ? Sight::kSeen : Sight::kHidden;
  }
  return sight_[place] == Sight::kSeen;
}

float RoadEnd::hopedLength(Measure measure, std::size_t rank) const {
  const float around = smallestSum(near_.data(), roads_->lengthsTo(measure, rank), near_.size());
  const std::size_t place = near_.size() + 2 * rank + (measure == Measure::kPath ? 0 : 1);
  if (sight_[place] == Sight::kHidden) return around;
  return std::min(around, straightLength(measure, rank));
}

RoadEnd::Choice RoadEnd::hopedChoice(Measure measure, std::size_t rank) const {
  const float hoped = hopedLength(measure, rank);
  const float* onwards = roads_->lengthsTo(measure, rank);
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i] + onwards[i] == hoped) return {hoped, static_cast<Node>(i)};
  }
  return {hoped, roads_->nodeOfPortal(rank)};
}

/// Looks at the best choice until it is one in sight.
RoadEnd::Choice RoadEnd::choice(Measure measure, std::size_t rank) {
  for (;;) {
    const Choice best = hopedChoice(measure, rank);
    if (best.length == kUnreachable) return best;
    if (roads_->isTurningPoint(best.node) ? canSee(best.node) : seesPortal(measure, rank)) {
      return best;
    }
  }
}

float RoadEnd::length(Measure measure, std::size_t rank) {
  const float length = choice(measure, rank).length;
  if (measure == Measure::kPath) return length;
  const std::uint32_t portal = regions_.portalsOf(region_).begin()[rank];
  const auto reach = static_cast<float>(regions_.portals()[portal].reach);
  return std::max(length, choice(Measure::kPath, rank).length - reach);
}

RoadEnd::Node RoadEnd::next(std::size_t rank) { return choice(Measure::kPath, rank).node; }

}  // namespace agrid::planning
