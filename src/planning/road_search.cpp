// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_search.h"

#include <algorithm>

#include "planning/local_road.h"
#include "planning/portal_search.h"
#include "planning/road_builder.h"

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
  if (!target.point &&
      std::binary_search(target.regions.begin(), target.regions.end(), query.start_region)) {
    return road;
  }
  if (target.point && query.start == *target.point) return road;
  if (target.point && level_.free.canSee(query.start, *target.point)) {
    road.corners.push_back({*target.point, 0, 0, 0, 0});
    road.length_bound_px = lengthPx(road);
    return road;
  }
  RoadEnd start(level_.free, level_.roadmap, query.start, query.start_region);
  return target.point ? toPoint(start, target, stop) : toArea(start, target, stop);
}

Road RoadSearch::toArea(RoadEnd& start, const Target& target, const StopCheck& stop) const {
  PortalSearch search(level_.roadmap, Measure::kPath, level_.path_landmarks, target, nullptr);
  const float length = search.find(start, kUnreachable, stop);
  const std::vector<Crossing> way = search.way();
  RoadBuilder builder(level_.free, level_.roadmap, start);
  builder.goThrough(way);
  builder.goInto(way.back());
  Road road = builder.road();
  road.length_bound_px = lengthBound(start, target, nullptr, length, stop);
  return road;
}

Road RoadSearch::toPoint(RoadEnd& start, const Target& target, const StopCheck& stop) const {
  RoadEnd goal(level_.free, level_.roadmap, *target.point, target.regions.front());
  LocalRoad local;
  if (start.region() == goal.region()) local = findLocalRoad(start, goal);
  PortalSearch search(level_.roadmap, Measure::kPath, level_.path_landmarks, target, &goal);
  const float length = search.find(start, local.length, stop);
  const std::vector<Crossing> way = search.way();
  RoadBuilder builder(level_.free, level_.roadmap, start);
  if (way.empty()) {
    builder.goAround(local.nodes, goal.point());
  } else {
    builder.goThrough(way);
    builder.goTo(goal, way.back());
  }
  Road road = builder.road();
  road.length_bound_px = lengthBound(start, target, &goal, length, stop);
  return road;
}

/// By a second search, which ends once no way can be shorter than nearly all of the one found.
double RoadSearch::lengthBound(RoadEnd& start, const Target& target, RoadEnd* goal, float found,
                               const StopCheck& stop) const {
  PortalSearch search(level_.roadmap, Measure::kLeast, level_.least_landmarks, target, goal);
  const double least = search.find(start, kProofEnough * found, stop) * (1 - kRounding);
  return std::max(least, target.distanceFrom(start.point()));
}

}  // namespace agrid::planning
