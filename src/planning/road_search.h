// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/local_road.h"
#include "planning/radius_level.h"
#include "planning/road.h"
#include "planning/road_builder.h"
#include "planning/road_end.h"
#include "planning/road_goal.h"
#include "planning/target.h"

namespace agrid::planning {

/// Where a road is to lead from and to.
struct RoadQuery {
  FinePoint start;
  std::uint32_t start_region = kNoNode;
  const Target* target = nullptr;
};

/// The shortest ways over a roadmap.
class RoadSearch {
 public:
  explicit RoadSearch(const RadiusLevel& level) : level_(level) {}

  /// @param query  its ends are connected
  /// @throws Stopped
  Road find(const RoadQuery& query, const StopCheck& stop) const;

 private:
  /// A way within one region, or none.
  struct LocalWay {
    LocalRoad road;
    RoadGoal::End* end = nullptr;
    float least = kUnreachable;  ///< no way in this region is shorter [px]
  };
  LocalWay findLocalWay(RoadEnd& start, RoadGoal& goal) const;
  void goInto(const RoadGoal& goal, const RoadGoal::End* end, const std::vector<Crossing>& way,
              RoadBuilder& builder) const;
  double lengthBound(RoadEnd& start, RoadGoal& goal, float proof_enough,
                     const StopCheck& stop) const;

  const RadiusLevel& level_;
};

}  // namespace agrid::planning
