// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "agrid/topology/topological_graph.h"

namespace agrid {

/// A sequence of areas and the doors between them: doors[i] leads from areas[i] to areas[i + 1].
struct Route {
  std::vector<std::size_t> areas;  ///< indices into AreaMap::areas
  std::vector<std::size_t> doors;  ///< indices into AreaMap::doors
  double length = 0;               ///< [m]
};

/// Whether a door (index into AreaMap::doors) may be used.
using DoorFilter = std::function<bool(std::size_t)>;

/// The shortest route over the graph, by straight lines from door to door; none if not connected.
std::optional<Route> findRoute(const AreaMap& areas, const TopologicalGraph& graph,
                               std::size_t start_area, std::size_t goal_area,
                               const DoorFilter& usable);

}  // namespace agrid
