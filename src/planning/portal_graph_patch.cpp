// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_graph_patch.h"

#include <algorithm>
#include <array>

namespace agrid::planning {
namespace {

/// Where the pixels beside those that were blocked are mostly connected [px].
constexpr int kDetour = 12;
/// Of a pixel that is being given a node.
constexpr std::uint32_t kPending = kNoNode - 1;

}  // namespace

std::uint32_t PortalGraphPatch::nodeAt(Pixel p) const {
  return graph_.nodeAt(free_.geometry().index(p));
}

void PortalGraphPatch::setNode(Pixel p, std::uint32_t node) {
  graph_.node_at_.edit(free_.geometry().index(p)) = node;
  if (node < graph_.nodeCount()) graph_.nodes_.edit(node).box.add(p);
}

/// As in `base` if that number is not in use.
std::uint32_t PortalGraphPatch::newNode(Pixel p) {
  std::uint32_t node = base_.nodeAt(free_.geometry().index(p));
  if (graph_.boxOf(node).high.x >= 0) {
    node = static_cast<std::uint32_t>(base_.nodeCount());
    while (node < graph_.nodeCount() && graph_.boxOf(node).high.x >= 0) ++node;
    if (node == graph_.nodeCount()) graph_.nodes_.push_back({});
  }
  PortalGraph::Node& made = graph_.nodes_.edit(node);
  made.class_of = classes_.classAt(p);
  renewed_[node] = p;
  moved_.insert(node);
  return node;
}

void PortalGraphPatch::apply(const PixelBox& box) {
  const MapGeometry& geometry = free_.geometry();
  std::vector<Pixel> blocked;
  std::vector<Pixel> freed;
  forEachPixel(clippedTo(geometry, box), [&](Pixel p) {
    const bool was_free = nodeAt(p) != kNoNode;
    if (was_free != free_.isFree(p)) (was_free ? blocked : freed).push_back(p);
  });
  if (blocked.empty() && freed.empty()) return;
  changed_ = true;
  box_ = box;
  moved_.clear();
  // Pairs of pixels next to those that changed belong to the same runs as theirs.
  const PixelBox near = clippedTo(geometry, widened(box, 2));
  std::set<NodePair> pairs;
  addPairsNear(near, pairs);
  block(blocked);
  free(freed);
  addPairsNear(near, pairs);
  redoPortals(pairs, near);
}

void PortalGraphPatch::addPairsNear(const PixelBox& near, std::set<NodePair>& pairs) const {
  forEachPixel(near, [&](Pixel p) {
    const std::uint32_t node = nodeAt(p);
    if (node == kNoNode) return;
    for (const Pixel q : {Pixel{p.x + 1, p.y}, Pixel{p.x, p.y + 1}}) {
      const std::uint32_t other = nodeAt(q);
      if (other != kNoNode && other != node) pairs.insert(std::minmax(node, other));
    }
  });
}

void PortalGraphPatch::block(const std::vector<Pixel>& blocked) {
  std::map<std::uint32_t, std::vector<Pixel>> beside;
  PixelBox around;
  for (const Pixel p : blocked) {
    beside[nodeAt(p)];
    around.add(p);
    graph_.node_at_.edit(free_.geometry().index(p)) = kNoNode;
  }
  for (const Pixel p : blocked) {
    for (const Pixel q : neighbours(p)) {
      if (nodeAt(q) != kNoNode) beside[nodeAt(q)].push_back(q);
    }
  }
  for (const auto& [node, pixels] : beside) {
    if (!pixels.empty()) {
      splitIfApart(node, pixels, around);
      continue;
    }
    // It was connected: none of its pixels is left.
    graph_.nodes_.edit(node).box = {};
    renewed_[node] = std::nullopt;
    moved_.insert(node);
  }
}

/// A way through pixels that are blocked now led from one of the pixels beside them to another: if
/// these are connected, so is all that is left of the node.
void PortalGraphPatch::splitIfApart(std::uint32_t node, const std::vector<Pixel>& beside,
                                    const PixelBox& around) {
  const PixelBox box = graph_.boxOf(node);
  const auto allSeen = [&](const PixelBox& window) {
    std::vector<bool> seen(window.columns() * window.rows());
    flood(beside.front(), window, seen);
    return std::all_of(beside.begin(), beside.end(),
                       [&](Pixel p) { return seen[indexIn(window, p)]; });
  };
  if (allSeen(clippedTo(free_.geometry(), widened(around, kDetour)))) return;
  std::vector<bool> seen(box.columns() * box.rows());
  flood(beside.front(), box, seen);
  for (const Pixel p : beside) {
    if (seen[indexIn(box, p)]) continue;
    moved_.insert(node);
    const std::vector<Pixel> piece = flood(p, box, seen);
    const std::uint32_t part = newNode(p);
    for (const Pixel q : piece) setNode(q, part);
  }
}

/// The pixels that are connected with `from` by pixels of its node within a window.
std::vector<Pixel> PortalGraphPatch::flood(Pixel from, const PixelBox& window,
                                           std::vector<bool>& seen) const {
  const std::uint32_t node = nodeAt(from);
  std::vector<Pixel> pixels{from};
  seen[indexIn(window, from)] = true;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (const Pixel q : neighbours(pixels[i])) {
      if (!holds(window, q) || nodeAt(q) != node || seen[indexIn(window, q)]) continue;
      seen[indexIn(window, q)] = true;
      pixels.push_back(q);
    }
  }
  return pixels;
}

void PortalGraphPatch::free(const std::vector<Pixel>& freed) {
  for (const Pixel first : freed) {
    if (nodeAt(first) != kNoNode) continue;
    std::set<std::uint32_t> beside;
    const std::vector<Pixel> piece = freePiece(first, beside);
    const std::uint32_t node = beside.empty() ? newNode(first) : mergedNode(beside);
    for (const Pixel p : piece) setNode(p, node);
  }
}

/// The freed pixels of one class that are connected within the box, and the nodes of this class
/// beside them.
std::vector<Pixel> PortalGraphPatch::freePiece(Pixel from, std::set<std::uint32_t>& beside) {
  const std::uint32_t class_of = classes_.classAt(from);
  std::vector<Pixel> piece{from};
  setNode(from, kPending);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (const Pixel q : neighbours(piece[i])) {
      const std::uint32_t node = nodeAt(q);
      if (node == kPending || !free_.isFree(q) || classes_.classAt(q) != class_of) continue;
      if (node != kNoNode) {
        beside.insert(node);
        continue;
      }
      if (!holds(box_, q)) continue;
      setNode(q, kPending);
      piece.push_back(q);
    }
  }
  return piece;
}

std::uint32_t PortalGraphPatch::mergedNode(const std::set<std::uint32_t>& nodes) {
  const std::uint32_t keeper = *nodes.begin();
  for (const std::uint32_t node : nodes) {
    if (node == keeper) continue;
    forEachPixel(graph_.boxOf(node), [&](Pixel p) {
      if (nodeAt(p) == node) setNode(p, keeper);
    });
    graph_.nodes_.edit(node).box = {};
    for (const std::uint32_t n : {node, keeper}) moved_.insert(n);
    renewed_[node] = std::nullopt;
  }
  return keeper;
}

bool PortalGraphPatch::mustRedo(const std::set<NodePair>& pairs, std::uint32_t a,
                                std::uint32_t b) const {
  return moved_.count(a) != 0 || moved_.count(b) != 0 || pairs.count(std::minmax(a, b)) != 0;
}

/// A border is cut into portals as a whole: all those between two nodes are made anew.
void PortalGraphPatch::redoPortals(const std::set<NodePair>& pairs, const PixelBox& near) {
  std::set<std::uint32_t> nodes = moved_;
  for (const NodePair& pair : pairs) nodes.insert({pair.first, pair.second});
  PixelBox scan = near;
  for (const std::uint32_t node : nodes) {
    const std::vector<std::uint32_t> portals = graph_.portalsOf(node);
    for (const std::uint32_t number : portals) {
      const Portal& portal = graph_.portals()[number];
      if (!mustRedo(pairs, portal.nodes[0], portal.nodes[1])) continue;
      scan = merged(scan, portal.box);
      drop(number);
    }
  }
  PortalRuns runs(scan.columns(), scan.low.x);
  for (int y = scan.low.y; y <= scan.high.y; ++y) {
    runs.nextRow();
    for (int x = scan.low.x; x <= scan.high.x; ++x) {
      const std::uint32_t node = nodeAt({x, y});
      if (node == kNoNode) continue;
      const std::uint32_t right = nodeAt({x + 1, y});
      const std::uint32_t above = nodeAt({x, y + 1});
      const auto isNew = [&](std::uint32_t other) {
        return other != kNoNode && other != node && mustRedo(pairs, node, other);
      };
      if (isNew(right)) runs.add({x, y}, false, node, right);
      if (isNew(above)) runs.add({x, y}, true, node, above);
    }
  }
  for (const Portal& portal : runs.portals(PortalCut::kParts)) add(portal);
}

void PortalGraphPatch::drop(std::uint32_t portal) {
  Portal& dropped = graph_.portals_.edit(portal);
  for (const std::uint32_t node : dropped.nodes) {
    std::vector<std::uint32_t>& list = graph_.nodes_.edit(node).portals;
    list.erase(std::find(list.begin(), list.end(), portal));
    relisted_.insert(node);
  }
  dropped.nodes = {kNoNode, kNoNode};
  new_portals_.erase(portal);
}

/// The same as in `base` if it is the same portal.
std::uint32_t PortalGraphPatch::portalNumberFor(const Portal& portal) const {
  const MapGeometry& geometry = free_.geometry();
  for (const std::uint32_t number : base_.portalsOf(base_.nodeAt(geometry.index(portal.middle)))) {
    const Portal& former = base_.portals()[number];
    if (former.middle == portal.middle && former.beyond == portal.beyond &&
        former.border.low == portal.border.low && former.border.high == portal.border.high &&
        graph_.portals()[number].nodes[0] == kNoNode) {
      return number;
    }
  }
  auto number = static_cast<std::uint32_t>(base_.portals().size());
  while (number < graph_.portals().size() && graph_.portals()[number].nodes[0] != kNoNode) ++number;
  return number;
}

void PortalGraphPatch::add(const Portal& portal) {
  const std::uint32_t number = portalNumberFor(portal);
  if (number == graph_.portals().size()) graph_.portals_.push_back({});
  graph_.portals_.edit(number) = portal;
  for (const std::uint32_t node : portal.nodes) {
    std::vector<std::uint32_t>& list = graph_.nodes_.edit(node).portals;
    list.insert(std::lower_bound(list.begin(), list.end(), number), number);
    relisted_.insert(node);
  }
  new_portals_.insert(number);
}

void PortalGraphPatch::finish() {
  if (!changed_) return;
  for (const std::uint32_t number : relisted_) {
    PortalGraph::Node& node = graph_.nodes_.edit(number);
    node.reach = 0;
    for (const std::uint32_t portal : node.portals) {
      node.reach = std::max(node.reach, graph_.portals_[portal].turningReach());
    }
  }
  graph_.joinComponents();
}

}  // namespace agrid::planning
