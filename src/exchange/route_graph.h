// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "agrid/exchange/export.h"

namespace agrid {

/// A place that a robot can drive to and turn at.
struct RouteNode {
  Point2 point_map = Point2::Zero();  ///< [m]
  // at most one of both; neither: a corner of a way
  std::optional<std::size_t> area;  ///< index into AreaMap::areas: its anchor
  std::optional<std::size_t> door;  ///< index into AreaMap::doors: in its middle
};

/// A straight line that a robot can drive both ways.
struct RouteLink {
  std::size_t a = 0;  ///< index of a node
  std::size_t b = 0;
};

/// Lines from anchor to door and from door to door that stay in free space.
struct RouteGraph {
  std::vector<RouteNode> nodes;  ///< areas, then doors, then corners
  std::vector<RouteLink> links;
  std::vector<std::string> warnings;  ///< which area or door is not in it
};

/// Between two places of one area the graph is at most this much longer than the way that
/// `find_way` knows.
inline constexpr double kRouteStretch = 1.1;

/// Doors that are closed, lead outside or have no place for the robot are left out. A way is only
/// put in where the others are too long (a greedy spanner: Althöfer et al. 1993).
RouteGraph findRouteGraph(const SemanticMap& map, const WayFinder& find_way);

}  // namespace agrid
