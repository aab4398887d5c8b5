// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_graph.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {

PortalGraph::PortalGraph(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                         const StopCheck& stop, PortalCut cut)
    : node_at_(free.geometry().pixelCount(), kNoNode) {
  labelNodes(free, classes_of_row, stop);
  findPortals(free.geometry(), stop, cut);
  joinComponents();
  listPortals();
}

void PortalGraph::labelNodes(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                             const StopCheck& stop) {
  const MapGeometry& geometry = free.geometry();
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
      const std::uint32_t from_left = here[x - 1] == here[x] ? node_at_[i - 1] : kNoNode;
      const std::uint32_t from_below = below[x] == here[x] ? node_at_[i - width] : kNoNode;
      node_at_[i] = from_left != kNoNode ? from_left : from_below;
      if (from_left != kNoNode && from_below != kNoNode) sets.unite(from_left, from_below);
      if (node_at_[i] != kNoNode) continue;
      node_at_[i] = sets.add();
      class_of_set.push_back(here[x]);
    }
  }
  numberNodes(geometry, sets, class_of_set);
}

void PortalGraph::numberNodes(const MapGeometry& geometry, DisjointSets& sets,
                              const std::vector<std::uint32_t>& class_of_set) {
  const std::vector<std::uint32_t> number = sets.numbers();
  std::size_t count = 0;
  for (const std::uint32_t n : number) count = std::max<std::size_t>(count, n + std::size_t{1});
  class_of_.resize(count);
  box_of_.resize(count);
  for (std::size_t set = 0; set < number.size(); ++set) class_of_[number[set]] = class_of_set[set];
  const auto width = static_cast<std::size_t>(geometry.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(geometry.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t& node = node_at_[y * width + x];
      if (node == kNoNode) continue;
      node = number[node];
      box_of_[node].add({static_cast<int>(x), static_cast<int>(y)});
    }
  }
}

void PortalGraph::findPortals(const MapGeometry& geometry, const StopCheck& stop, PortalCut cut) {
  const auto width = static_cast<std::size_t>(geometry.width);
  PortalRuns runs(width);
  for (int y = 1; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    runs.nextRow();
    for (int x = 1; x + 1 < geometry.width; ++x) {
      const std::size_t i = geometry.index({x, y});
      const std::uint32_t node = node_at_[i];
      if (node == kNoNode) continue;
      const std::uint32_t right = node_at_[i + 1];
      const std::uint32_t above = node_at_[i + width];
      if (right != kNoNode && right != node) runs.add({x, y}, false, node, right);
      if (above != kNoNode && above != node) runs.add({x, y}, true, node, above);
    }
  }
  portals_ = runs.portals(cut);
}

void PortalGraph::joinComponents() {
  DisjointSets sets;
  for (std::size_t i = 0; i < nodeCount(); ++i) sets.add();
  for (const Portal& portal : portals_) sets.unite(portal.nodes[0], portal.nodes[1]);
  component_of_ = sets.numbers();
}

void PortalGraph::listPortals() {
  portals_from_.assign(nodeCount() + 1, 0);
  for (const Portal& portal : portals_) {
    for (const std::uint32_t node : portal.nodes) ++portals_from_[node + 1];
  }
  for (std::size_t i = 1; i < portals_from_.size(); ++i) portals_from_[i] += portals_from_[i - 1];
  portals_of_.resize(2 * portals_.size());
  std::vector<std::uint32_t> next(portals_from_.begin(), portals_from_.end() - 1);
  for (std::uint32_t p = 0; p < portals_.size(); ++p) {
    for (const std::uint32_t node : portals_[p].nodes) portals_of_[next[node]++] = p;
  }
}

}  // namespace agrid::planning
