// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_search.h"

#include <algorithm>

#include "planning/portal_search.h"

namespace agrid::planning {
namespace {

/// Sums of floats are rounded, by less than this part.
constexpr double kRounding = 1e-5;
/// A path is proved to be short up to this part: the last half percent takes most of the time.
constexpr float kProofEnough = 0.995F;

}  // namespace

Road RoadSearch::find(const RoadQuery& query, const StopCheck& stop) const {
  stop.check();
  const Target& target = *query.target;
  Road road;
  road.corners = {{query.start, 0, 0, 0, 0}};
  road.regions = {query.start_region};
  const std::size_t start_pixel = level_.free.geometry().index(query.start.pixel());
  if (!target.point && level_.labels()[start_pixel] == target.label) return road;
  if (target.point && query.start == *target.point) return road;
  if (target.point && level_.free.canSee(query.start, *target.point)) {
    road.corners.push_back({*target.point, 0, 0, 0, 0});
    road.length_bound_px = lengthPx(road);
    return road;
  }
  RoadEnd start(level_.free, level_.roadmap, query.start, query.start_region);
  RoadGoal goal(level_, target);
  const LocalWay local = findLocalWay(start, goal);
  PortalSearch search(level_.roadmap, Measure::kPath, level_.path_landmarks, goal);
  const float length = search.find(start, local.road.length, stop);
  const std::vector<Crossing> way = search.way();
  RoadBuilder builder(level_.roadmap, start);
  const RoadGoal::End* end = way.empty() ? local.end : search.end();
  if (way.empty()) {
    builder.goAround(local.road.nodes, end->road.point());
  } else {
    builder.goThrough(way);
    if (end) builder.goTo(search.end()->road, way.back());
  }
  if (!target.point) goInto(goal, end, way, builder);
  road = builder.road();
  road.length_bound_px =
      lengthBound(start, goal, std::min(kProofEnough * length, local.least), stop);
  return road;
}

/// From the border of an area to a place in it.
void RoadSearch::goInto(const RoadGoal& goal, const RoadGoal::End* end,
                        const std::vector<Crossing>& way, RoadBuilder& builder) const {
  const Portal& border = end ? *end->border : level_.roadmap.regions().portals()[way.back().portal];
  const std::size_t side = end ? border.sideOf(goal.target().label) : way.back().side;
  builder.goInto(goal, border, side == 0 ? border.middle : border.beyond);
}

/// To the ends in the start's own region, without leaving it.
RoadSearch::LocalWay RoadSearch::findLocalWay(RoadEnd& start, RoadGoal& goal) const {
  LocalWay best;
  for (RoadGoal::End* end : goal.endsOf(start.region())) {
    const auto straight = static_cast<float>(distancePx(start.point(), end->road.point()));
    LocalRoad local;
    if (straight < best.road.length) {
      local = end->border && level_.free.canSee(start.point(), end->road.point())
                  ? LocalRoad{straight, {}}
                  : findLocalRoad(start, end->road);
    } else {
      local.length = straight;
    }
    best.least = std::min(best.least, std::max(local.length - end->reach, 0.0F));
    if (local.length < best.road.length) {
      best.road = std::move(local);
      best.end = end;
    }
  }
  return best;
}

/// By a second search, which ends once no way can be shorter than nearly all of the one found.
double RoadSearch::lengthBound(RoadEnd& start, RoadGoal& goal, float proof_enough,
                               const StopCheck& stop) const {
  PortalSearch search(level_.roadmap, Measure::kLeast, level_.least_landmarks, goal);
  const double least = search.find(start, proof_enough, stop) * (1 - kRounding);
  return std::max(least, goal.target().distanceFrom(start.point()));
}

}  // namespace agrid::planning
