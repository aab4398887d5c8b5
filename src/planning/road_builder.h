// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/portal_search.h"
#include "planning/road.h"
#include "planning/road_end.h"
#include "planning/road_goal.h"

namespace agrid::planning {

/// Puts a road together from what the roadmap stores.
class RoadBuilder {
 public:
  RoadBuilder(const Roadmap& roadmap, RoadEnd& start);

  /// Goes through the portals of a way to the middle of the last one.
  void goThrough(const std::vector<Crossing>& way);
  /// From the last portal to a goal in the region that the way enters.
  void goTo(RoadEnd& goal, const Crossing& last);
  /// From the middle of a border to a near place in the goal's area, of which `first` is one.
  void goInto(const RoadGoal& goal, const Portal& border, Pixel first);
  /// Around turning points of the start's region to a point.
  void goAround(const std::vector<RegionRoads::Node>& nodes, FinePoint goal);

  Road road() { return std::move(road_); }

 private:
  void follow(const RegionRoads& roads, std::size_t rank, RegionRoads::Node node);
  void add(const RegionRoads& roads, RegionRoads::Node node);
  void push(FinePoint at, std::int8_t blocked_x, std::int8_t blocked_y);

  const Roadmap& roadmap_;
  RoadEnd& start_;
  Road road_;
};

}  // namespace agrid::planning
