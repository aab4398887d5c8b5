// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

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
  std::size_t nodeCount() const { return class_of_.size(); }
  /// Of its pixels: index of the cell, or label of the area.
  std::uint32_t classOf(std::uint32_t node) const { return class_of_[node]; }
  /// Nodes with the same component, and no others, are connected.
  std::uint32_t componentOf(std::uint32_t node) const { return component_of_[node]; }
  const PixelBox& boxOf(std::uint32_t node) const { return box_of_[node]; }

  const std::vector<Portal>& portals() const { return portals_; }
  /// Indices of a node's portals: [begin, end) of a list.
  struct Range {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Range portalsOf(std::uint32_t node) const {
    return {portals_of_.data() + portals_from_[node], portals_of_.data() + portals_from_[node + 1]};
  }

 private:
  void labelNodes(const FreeSpace& free, const ClassesOfRow& classes_of_row, const StopCheck& stop);
  void numberNodes(const MapGeometry& geometry, DisjointSets& sets,
                   const std::vector<std::uint32_t>& class_of_set);
  void findPortals(const MapGeometry& geometry, const StopCheck& stop, PortalCut cut);
  void joinComponents();
  void listPortals();

  std::vector<std::uint32_t> node_at_;
  std::vector<std::uint32_t> class_of_;
  std::vector<std::uint32_t> component_of_;
  std::vector<PixelBox> box_of_;
  std::vector<Portal> portals_;
  std::vector<std::uint32_t> portals_from_;
  std::vector<std::uint32_t> portals_of_;
};

}  // namespace agrid::planning
