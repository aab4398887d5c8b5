// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/topology/topological_graph.h"

#include <unordered_map>

namespace agrid {

TopologicalGraph buildGraph(const AreaMap& areas) {
  std::unordered_map<std::uint32_t, std::size_t> index_of;
  for (std::size_t i = 0; i < areas.areas.size(); ++i) {
    index_of.emplace(static_cast<std::uint32_t>(areas.areas[i].id), i);
  }
  TopologicalGraph graph;
  graph.passages.resize(areas.areas.size());
  for (std::size_t d = 0; d < areas.doors.size(); ++d) {
    const auto& sides = areas.doors[d].areas;
    const auto a = index_of.find(static_cast<std::uint32_t>(sides[0]));
    const auto b = index_of.find(static_cast<std::uint32_t>(sides[1]));
    if (a == index_of.end() || b == index_of.end()) continue;
    graph.passages[a->second].push_back({d, b->second});
    graph.passages[b->second].push_back({d, a->second});
  }
  return graph;
}

}  // namespace agrid
