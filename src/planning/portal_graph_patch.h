// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "planning/portal_graph.h"
#include "planning/region_classes.h"

namespace agrid::planning {

/// Nodes, each with one of its pixels; none: it has none.
using RenewedNodes = std::map<std::uint32_t, std::optional<Pixel>>;

/// Brings a graph of regions up to date where pixels became free or are no longer. What it makes is
/// what a graph made anew would have, but for the numbers. Those of `base` are given back to what
/// is as in `base`.
class PortalGraphPatch {
 public:
  /// @param graph  of a free space that differs from `free` in some boxes
  /// @param base  of the same classes and more free pixels than either
  /// The arguments must outlive the object.
  PortalGraphPatch(PortalGraph& graph, const PortalGraph& base, const FreeSpace& free,
                   const RegionClasses& classes)
      : graph_(graph), base_(base), free_(free), classes_(classes) {}

  /// Looks at the pixels of a box.
  void apply(const PixelBox& box);
  /// After all boxes.
  void finish();

  bool changedAnything() const { return changed_; }
  /// Nodes that are new, with one of their pixels, or that have none any more.
  const RenewedNodes& renewed() const { return renewed_; }
  /// Nodes that have other portals than before.
  const std::set<std::uint32_t>& relisted() const { return relisted_; }
  const std::set<std::uint32_t>& newPortals() const { return new_portals_; }

 private:
  using NodePair = std::pair<std::uint32_t, std::uint32_t>;
  std::uint32_t nodeAt(Pixel p) const;
  void setNode(Pixel p, std::uint32_t node);
  std::uint32_t newNode(Pixel p);
  void addPairsNear(const PixelBox& near, std::set<NodePair>& pairs) const;
  void block(const std::vector<Pixel>& blocked);
  void splitIfApart(std::uint32_t node, const std::vector<Pixel>& beside, const PixelBox& around);
  std::vector<Pixel> flood(Pixel from, const PixelBox& window, std::vector<bool>& seen) const;
  void free(const std::vector<Pixel>& freed);
  std::vector<Pixel> freePiece(Pixel from, std::set<std::uint32_t>& beside);
  std::uint32_t mergedNode(const std::set<std::uint32_t>& nodes);
  void redoPortals(const std::set<NodePair>& pairs, const PixelBox& near);
  void drop(std::uint32_t portal);
  void add(const Portal& portal);
  std::uint32_t portalNumberFor(const Portal& portal) const;
  bool mustRedo(const std::set<NodePair>& pairs, std::uint32_t a, std::uint32_t b) const;

  PortalGraph& graph_;
  const PortalGraph& base_;
  const FreeSpace& free_;
  const RegionClasses& classes_;
  bool changed_ = false;
  PixelBox box_;                   ///< that is looked at
  std::set<std::uint32_t> moved_;  ///< nodes of which pixels went to other nodes, in this box
  RenewedNodes renewed_;
  std::set<std::uint32_t> relisted_;
  std::set<std::uint32_t> new_portals_;
};

}  // namespace agrid::planning
