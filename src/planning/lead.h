// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planning/portal_graph.h"

namespace agrid::planning {

/// Where a search ends: at one point, or at any pixel of an area.
struct Target {
  std::optional<FinePoint> point;
  std::uint16_t label = 0;           ///< without a point: of the area
  PixelBox box;                      ///< of the target's pixels
  std::vector<std::uint32_t> nodes;  ///< nodes with pixels of the target that the start reaches

  /// No way from there to the target is shorter [px].
  double distanceFrom(FinePoint p) const;
};

/// The nodes that a path search may use, and what the graph proves about the path's length.
struct Lead {
  std::vector<std::uint32_t> nodes;  ///< connected, with the start's node and one of the target's
  double length_bound_px = 0;        ///< no path is shorter
};

/// Finds the nodes on ways through the portals' middles that are not much longer than the shortest
/// such way.
/// @param start_node  the node of `start`; connected with the target's nodes
Lead findLead(const PortalGraph& graph, FinePoint start, std::uint32_t start_node,
              const Target& target, const StopCheck& stop);

}  // namespace agrid::planning
