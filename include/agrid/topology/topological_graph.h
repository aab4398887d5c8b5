// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "agrid/areas/area_map.h"

namespace agrid {

/// A door used in one direction.
struct Passage {
  std::size_t door = 0;  ///< index into AreaMap::doors
  std::size_t area = 0;  ///< index into AreaMap::areas: where it leads
};

/// Areas are its nodes, doors its edges (paper, 1 and 4). A value: indices into the AreaMap it was
/// made from, never pointers.
struct TopologicalGraph {
  std::vector<std::vector<Passage>> passages;  ///< for each area, in order of the doors
};

/// @return one node per area; doors to the outside are no edges
TopologicalGraph buildGraph(const AreaMap& areas);

/// The areas that cannot be entered from the main part of the map: the largest set [m^2] of areas
/// joined by doors that are not closed.
/// @return indices into AreaMap::areas, ascending
std::vector<std::size_t> unreachableAreas(const AreaMap& areas, const TopologicalGraph& graph);

}  // namespace agrid
