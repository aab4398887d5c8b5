// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_graph.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {

PortalGraph::PortalGraph(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                         const StopCheck& stop, PortalCut cut) {
  Parts parts;
  labelNodes(free, classes_of_row, stop, parts);
  findPortals(free.geometry(), stop, cut, parts);
  listPortals(parts);
  node_at_ = PagedArray<std::uint32_t, 10>(std::move(parts.node_at));
  nodes_ = PagedArray<Node, 4>(std::move(parts.nodes));
  portals_ = PagedArray<Portal, 5>(std::move(parts.portals));
  joinComponents();
}

void PortalGraph::labelNodes(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                             const StopCheck& stop, Parts& parts) {
  const MapGeometry& geometry = free.geometry();
  std::vector<std::uint32_t>& node_at = parts.node_at;
  node_at.assign(geometry.pixelCount(), kNoNode);
  const auto width = static_cast<std::size_t>(geometry.width);
  DisjointSets sets;
  std::vector<std::uint32_t> class_of_set;
  std::vector<std::uint32_t> here(width);
  std::vector<std::uint32_t> below(width);
  for (int y = 1; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    std::swap(here, below);
    classes_of_row(y, here);
    // Free pixels never lie on the outermost ring, so that each has all four neighbours.
    for (std::size_t x = 1; x + 1 < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      if (!free.isFree({static_cast<int>(x), y})) continue;
      const std::uint32_t from_left = here[x - 1] == here[x] ? node_at[i - 1] : kNoNode;
      const std::uint32_t from_below = below[x] == here[x] ? node_at[i - width] : kNoNode;
      node_at[i] = from_left != kNoNode ? from_left : from_below;
      if (from_left != kNoNode && from_below != kNoNode) sets.unite(from_left, from_below);
      if (node_at[i] != kNoNode) continue;
      node_at[i] = sets.add();
      class_of_set.push_back(here[x]);
    }
  }
  numberNodes(geometry, sets, class_of_set, parts);
}

void PortalGraph::numberNodes(const MapGeometry& geometry, DisjointSets& sets,
                              const std::vector<std::uint32_t>& class_of_set, Parts& parts) {
  const std::vector<std::uint32_t> number = sets.numbers();
  std::size_t count = 0;
  for (const std::uint32_t n : number) count = std::max<std::size_t>(count, n + std::size_t{1});
  std::vector<Node>& nodes = parts.nodes;
  nodes.resize(count);
  for (std::size_t set = 0; set < number.size(); ++set) {
    nodes[number[set]].class_of = class_of_set[set];
  }
  const auto width = static_cast<std::size_t>(geometry.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(geometry.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t& node = parts.node_at[y * width + x];
      if (node == kNoNode) continue;
      node = number[node];
      nodes[node].box.add({static_cast<int>(x), static_cast<int>(y)});
    }
  }
}

void PortalGraph::findPortals(const MapGeometry& geometry, const StopCheck& stop, PortalCut cut,
                              Parts& parts) {
  const std::vector<std::uint32_t>& node_at = parts.node_at;
  const auto width = static_cast<std::size_t>(geometry.width);
  PortalRuns runs(width);
  for (int y = 1; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    runs.nextRow();
    for (int x = 1; x + 1 < geometry.width; ++x) {
      const std::size_t i = geometry.index({x, y});
      const std::uint32_t node = node_at[i];
      if (node == kNoNode) continue;
      const std::uint32_t right = node_at[i + 1];
      const std::uint32_t above = node_at[i + width];
      if (right != kNoNode && right != node) runs.add({x, y}, false, node, right);
      if (above != kNoNode && above != node) runs.add({x, y}, true, node, above);
    }
  }
  parts.portals = runs.portals(cut);
}

void PortalGraph::joinComponents() {
  DisjointSets sets(nodeCount());
  for (const Portal& portal : portals_) {
    if (portal.nodes[0] != kNoNode) sets.unite(portal.nodes[0], portal.nodes[1]);
  }
  component_of_ = sets.numbers();
}

void PortalGraph::listPortals(Parts& parts) {
  for (std::uint32_t p = 0; p < parts.portals.size(); ++p) {
    const Portal& portal = parts.portals[p];
    for (const std::uint32_t number : portal.nodes) {
      Node& node = parts.nodes[number];
      node.portals.push_back(p);
      node.reach = std::max(node.reach, portal.turningReach());
    }
  }
}

}  // namespace agrid::planning
