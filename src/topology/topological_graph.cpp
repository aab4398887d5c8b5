// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/topology/topological_graph.h"

#include <unordered_map>

#include <boost/pending/disjoint_sets.hpp>

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

std::vector<std::size_t> unreachableAreas(const AreaMap& areas, const TopologicalGraph& graph) {
  const std::size_t count = areas.areas.size();
  boost::disjoint_sets_with_storage<> parts(count);
  for (std::size_t a = 0; a < count; ++a) {
    for (const Passage& passage : graph.passages[a]) {
      if (areas.doors[passage.door].state != DoorState::kClosed) parts.union_set(a, passage.area);
    }
  }
  std::vector<double> sizes(count, 0);
  std::size_t main = 0;
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t part = parts.find_set(a);
    sizes[part] += areas.areas[a].size;
    if (sizes[part] > sizes[main]) main = part;
  }
  std::vector<std::size_t> apart;
  for (std::size_t a = 0; a < count; ++a) {
    if (parts.find_set(a) != main) apart.push_back(a);
  }
  return apart;
}

}  // namespace agrid
