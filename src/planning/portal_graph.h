// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "planning/free_space.h"
#include "planning/stop.h"
#include "tags/disjoint_sets.h"

namespace agrid::planning {

constexpr std::uint32_t kNoNode = 0xffffffff;
/// Whether portals are maximal runs, or parts of them: sixteen of a run, if each is then 3 to 12
/// pixels long and wide.
enum class PortalCut { kWholeRuns, kParts };

/// A rectangle of pixels, both corners inside.
struct PixelBox {
  Pixel low{0x7fffffff, 0x7fffffff};
  Pixel high{-1, -1};

  void add(Pixel p);
  std::size_t columns() const { return static_cast<std::size_t>(high.x - low.x + 1); }
  std::size_t rows() const { return static_cast<std::size_t>(high.y - low.y + 1); }
};

/// A run of pixel pairs (side by side or one above the other) whose two pixels are free and lie in
/// two nodes: a maximal one, or a part of one that is no longer than asked for.
struct Portal {
  std::array<std::uint32_t, 2> nodes{kNoNode, kNoNode};
  Pixel middle;  ///< a pixel of its middle pair, in nodes[0]
  Pixel beyond;  ///< the other pixel of its middle pair, in nodes[1]
  PixelBox box;  ///< of the pixels of its pairs on both sides
  PixelBox
      border;  ///< of the borders between its pairs, in corners: (x, y) is pixel (x, y)'s lower
  double reach = 0;  ///< no place on those borders is farther from crossing() by path [px]

  /// The middle of the border between the pixels of the middle pair.
  FinePoint crossing() const {
    return {(std::int64_t{middle.x} + beyond.x) * (kFine / 2),
            (std::int64_t{middle.y} + beyond.y) * (kFine / 2)};
  }
  /// Whether a straight line from the border into one of the nodes can lead to a point ...
  bool canLeadTo(FinePoint p, std::uint32_t node) const;
  /// ... or to anywhere on another border.
  bool canLeadToBorder(const Portal& other, std::uint32_t node) const;
  /// Distance of a point to the border's box [px].
  double distanceToBorder(FinePoint p) const;
  /// Between two borders' boxes [px].
  double distanceToBorder(const Portal& other) const;
  bool straight = false;  ///< the border is a straight line, nodes[0] all on its lower side

  std::size_t sideOf(std::uint32_t node) const { return nodes[0] == node ? 0 : 1; }

  std::uint32_t other(std::uint32_t node) const { return nodes[nodes[0] == node ? 1 : 0]; }
};

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
