// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/radius_level.h"
#include "planning/road.h"
#include "planning/road_end.h"
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
  Road toArea(RoadEnd& start, const Target& target, const StopCheck& stop) const;
  double lengthBound(RoadEnd& start, const Target& target, RoadEnd* goal, float found,
                     const StopCheck& stop) const;
  Road toPoint(RoadEnd& start, const Target& target, const StopCheck& stop) const;

  const RadiusLevel& level_;
};

}  // namespace agrid::planning
