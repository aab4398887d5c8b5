// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "agrid/planning/lead_follower.h"
#include "planning/cost_line.h"
#include "planning/fine_point.h"

namespace agrid::test {

using Rows = std::vector<std::string>;

constexpr double kResolution = 0.1;

/// '#' lethal, 'i' inscribed, '?' unknown, '5' a cost of 50, else free; first row on top; the
/// lower left corner at (-1, 2).
inline Costmap costmap(const Rows& rows) {
  Costmap map;
  map.geometry.width = static_cast<int>(rows.front().size());
  map.geometry.height = static_cast<int>(rows.size());
  map.geometry.resolution = kResolution;
  map.geometry.map_from_image.position = {-1, 2};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      map.costs.push_back(c == '#'   ? kLethal
                          : c == 'i' ? kInscribed
                          : c == '?' ? kNoInformation
                          : c == '5' ? std::uint8_t{50}
                                     : std::uint8_t{0});
    }
  }
  return map;
}

/// Centre of the pixel at a column and a row from the top.
inline Point2 at(const Costmap& map, int column, int row) {
  return map.geometry.center({column, map.geometry.height - 1 - row});
}

/// Whether a path touches no pixel that is blocked, but the start's, steps from pixel to pixel, and
/// leads from start to goal.
inline void expectFree(const Costmap& map, const FollowedPath& path, const Segment& ends,
                       const CostRules& rules = {}) {
  ASSERT_FALSE(path.path.empty());
  EXPECT_LT((path.path.front() - ends.a).norm(), 1e-4);
  EXPECT_LT((path.path.back() - ends.b).norm(), 1e-4);
  const planning::CostField field(map, rules, map.geometry.pixelAt(ends.a).value());
  double cost = 0;
  for (std::size_t i = 1; i < path.path.size(); ++i) {
    EXPECT_LE((path.path[i] - path.path[i - 1]).norm(), kResolution * 1.001);
    const double step =
        planning::costOfLine(field, planning::pixelCoordinates(map.geometry, path.path[i - 1]),
                             planning::pixelCoordinates(map.geometry, path.path[i]));
    ASSERT_LT(step, std::numeric_limits<double>::infinity()) << "at step " << i;
    cost += step * kResolution;
  }
  EXPECT_NEAR(path.cost, cost, 1e-3);
}

}  // namespace agrid::test
