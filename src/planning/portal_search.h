// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "planning/landmarks.h"
#include "planning/road_end.h"
#include "planning/road_goal.h"
#include "planning/roadmap.h"
#include "planning/stop.h"

namespace agrid::planning {

/// A* over the portals of a roadmap.
class PortalSearch {
 public:
  /// @param landmarks  for the measure
  PortalSearch(const Roadmap& roadmap, Measure measure, const Landmarks& landmarks, RoadGoal& goal);

  /// @param limit  ways that are not shorter are not looked for [px]
  /// @return length of the shortest way, the limit if there is none [px]
  /// @throws Stopped
  float find(RoadEnd& start, float limit, const StopCheck& stop);

  /// The crossings of the way found last; none if there is none.
  std::vector<Crossing> way() const;
  /// Where it ends; nullptr: as soon as the last region is entered.
  RoadGoal::End* end() const { return end_; }

 private:
  struct State;
  struct Memory;
  static Memory& threadMemory();

  void findGoalLengths();
  float restOf(std::uint32_t portal) const;
  void push(float estimate, std::uint32_t state, std::uint32_t kind);
  void begin(RoadEnd& start);
  void takeFirstLeg(RoadEnd& start, std::uint32_t state, std::uint32_t kind);
  void takeLastLeg(std::uint32_t state, std::uint32_t kind);
  void reach(std::uint32_t state, std::uint32_t parent, float cost);
  void expand(std::uint32_t state);

  const Roadmap& roadmap_;
  const PortalGraph& regions_;
  Measure measure_;
  const Landmarks& landmarks_;
  RoadGoal& goal_;
  std::array<float, Landmarks::kCount>
      goal_nearest_;  ///< least sum of a portal's length and the leg to the goal
  std::array<float, Landmarks::kCount> goal_farthest_;  ///< greatest difference
  Memory& memory_;
  float best_ = kUnreachable;
  std::uint32_t last_;
  RoadGoal::End* end_ = nullptr;
};

}  // namespace agrid::planning
