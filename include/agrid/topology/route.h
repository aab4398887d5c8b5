// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "agrid/topology/topological_graph.h"

namespace agrid {

/// In place of a door where two areas meet without one.
constexpr std::size_t kNoDoor = static_cast<std::size_t>(-1);

/// A sequence of areas and the doors between them: doors[i] leads from areas[i] to areas[i + 1].
struct Route {
  std::vector<std::size_t> areas;  ///< indices into AreaMap::areas
  std::vector<std::size_t> doors;  ///< indices into AreaMap::doors, or kNoDoor
  double length = 0;               ///< [m]
};

/// Whether a door (index into AreaMap::doors) may be used.
using DoorFilter = std::function<bool(std::size_t)>;

/// What routes are asked for: from a place in one area to a place in another.
struct RouteQuery {
  std::size_t start_area = 0;         ///< node of the graph
  std::size_t goal_area = 0;          ///< node of the graph
  Point2 start_map = Point2::Zero();  ///< [m]
  Point2 goal_map = Point2::Zero();   ///< [m]
  DoorFilter usable;                  ///< empty: every door
};

/// The shortest routes over the graph by straight lines from door to door, each through other doors
/// and without entering an area twice (Yen, "Finding the k shortest loopless paths in a network",
/// 1971).
/// @param door_positions  where the graph's doors are, by their indices, map frame [m]
/// @return at most `max_routes`, shortest first; empty if not connected
/// @throws std::invalid_argument if an area of the query is no node of the graph
std::vector<Route> findRoutes(const TopologicalGraph& graph,
                              const std::vector<Point2>& door_positions, const RouteQuery& query,
                              std::size_t max_routes);

/// The shortest route from anchor to anchor; none if not connected.
/// @throws std::invalid_argument if an area does not exist
std::optional<Route> findRoute(const AreaMap& areas, const TopologicalGraph& graph,
                               std::size_t start_area, std::size_t goal_area,
                               const DoorFilter& usable);

}  // namespace agrid
