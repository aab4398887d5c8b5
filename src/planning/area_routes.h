// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/topology/route.h"
#include "planning/portal_graph.h"
#include "planning/target.h"

namespace agrid::planning {

/// The first level for one radius: the pieces of free space that each area has for it are the nodes
/// of a topological graph, the openings between pieces its doors. A route over it can be driven.
class AreaRoutes {
 public:
  /// @param graph  over the areas; `map` and `graph` must outlive the object
  AreaRoutes(const SemanticMap& map, const PortalGraph& graph);

  /// @param start  a free pixel's point
  /// @param target  connected with it; an area is gone to as if to its anchor
  /// @return routes that differ in their doors, shortest first
  std::vector<Route> find(FinePoint start, const Target& target, std::size_t max_routes,
                          const StopCheck& stop) const;

 private:
  std::size_t doorOf(const Portal& portal) const;
  std::vector<RouteQuery> queries(FinePoint start, const Target& target) const;
  Route named(const Route& route) const;

  const SemanticMap& map_;
  const PortalGraph& graph_;
  TopologicalGraph passages_;   ///< areas: nodes of graph_; doors: portals of graph_
  std::vector<Point2> places_;  ///< of the portals, map frame [m]
};

}  // namespace agrid::planning
