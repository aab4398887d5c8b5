// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "agrid/map/paged_array.h"
#include "planning/free_space.h"
#include "planning/portal_runs.h"
#include "planning/stop.h"
#include "tags/disjoint_sets.h"

namespace agrid::planning {

/// Writes the class of each pixel of row `y` (first argument): the cell or the area it belongs to.
using ClassesOfRow = std::function<void(int, std::vector<std::uint32_t>&)>;

/// Free space as a graph. Pixels are given classes: the cells of the A-Grid (second level), or the
/// areas (first level). A node is a 4-connected piece of the free pixels of one class; portals join
/// nodes of different classes. It connects exactly what the free pixels connect, for any grid lines
/// and any size of cells: classes index free space, they never decide what is free.
class PortalGraph {
 public:
  PortalGraph(const FreeSpace& free, const ClassesOfRow& classes_of_row, const StopCheck& stop = {},
              PortalCut cut = PortalCut::kWholeRuns);

  /// The node of a pixel that the map contains; kNoNode if it is not free.
  std::uint32_t nodeAt(std::size_t pixel_index) const { return node_at_[pixel_index]; }
  /// Some of them may be without pixels, in a graph that was patched.
  std::size_t nodeCount() const { return nodes_.size(); }
  /// Of its pixels: index of the cell, or label of the area.
  std::uint32_t classOf(std::uint32_t node) const { return nodes_[node].class_of; }
  /// Nodes with the same component, and no others, are connected.
  std::uint32_t componentOf(std::uint32_t node) const { return component_of_[node]; }
  /// All its pixels lie in it; in a graph that was patched it may be too large.
  const PixelBox& boxOf(std::uint32_t node) const { return nodes_[node].box; }
  /// No turning point of the node's paths lies farther beyond its pixels, in either direction [px].
  int reachOf(std::uint32_t node) const { return nodes_[node].reach; }

  /// Those of a graph that was patched may be out of use: their nodes are kNoNode.
  const PagedArray<Portal, 5>& portals() const { return portals_; }
  /// Indices of a node's portals, in ascending order.
  const std::vector<std::uint32_t>& portalsOf(std::uint32_t node) const {
    return nodes_[node].portals;
  }

 private:
  friend class PortalGraphPatch;
  struct Node {
    std::uint32_t class_of = 0;
    int reach = 0;
    PixelBox box;
    std::vector<std::uint32_t> portals;
  };
  /// While it is made.
  struct Parts {
    std::vector<std::uint32_t> node_at;
    std::vector<Node> nodes;
    std::vector<Portal> portals;
  };
  static void labelNodes(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                         const StopCheck& stop, Parts& parts);
  static void numberNodes(const MapGeometry& geometry, DisjointSets& sets,
                          const std::vector<std::uint32_t>& class_of_set, Parts& parts);
  static void findPortals(const MapGeometry& geometry, const StopCheck& stop, PortalCut cut,
                          Parts& parts);
  static void listPortals(Parts& parts);
  void joinComponents();

  PagedArray<std::uint32_t, 10> node_at_;
  PagedArray<Node, 4> nodes_;
  PagedArray<Portal, 5> portals_;
  std::vector<std::uint32_t> component_of_;
};

}  // namespace agrid::planning
