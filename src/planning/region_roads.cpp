// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_roads.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace agrid::planning {
namespace {

using Node = RegionRoads::Node;
using Edge = RegionRoads::Edge;

/// Whether a shortest path from anywhere on the portal's border can bend at the point.
bool canBendTowards(const TurningPoint& point, const Portal& portal) {
  const auto corner = [](int x, int y) {
    return FinePoint{x * kFine - kFine / 2, y * kFine - kFine / 2};
  };
  const PixelBox& b = portal.border;
  return point.isTangentTo(portal.crossing()) || point.isTangentTo(corner(b.low.x, b.low.y)) ||
         point.isTangentTo(corner(b.high.x, b.low.y)) ||
         point.isTangentTo(corner(b.low.x, b.high.y)) ||
         point.isTangentTo(corner(b.high.x, b.high.y));
}

/// Whether two portals of a region lead to the same other one.
bool leadToTheSame(const Portal& a, const Portal& b) {
  return std::minmax({a.nodes[0], a.nodes[1]}) == std::minmax({b.nodes[0], b.nodes[1]});
}

}  // namespace

RegionRoads::RegionRoads(const FreeSpace& free, std::vector<TurningPoint> points,
                         const std::vector<const Portal*>& portals)
    : points_(std::move(points)) {
  for (const Portal* portal : portals) crossings_.push_back(portal->crossing());
  findEdges(free);
  std::vector<View> views;
  for (std::size_t i = 0; i < portals.size(); ++i) views.push_back(viewOf(free, portals, i));
  path_.reserve(portals.size() * nodeCount());
  least_.reserve(portals.size() * nodeCount());
  next_.reserve(portals.size() * nodeCount());
  for (std::size_t i = 0; i < portals.size(); ++i) {
    findPaths(views, i);
    findLeast(portals, views, i);
  }
}

void RegionRoads::findEdges(const FreeSpace& free) {
  std::vector<std::vector<Edge>> edges_of(points_.size());
  for (std::size_t a = 0; a < points_.size(); ++a) {
    for (std::size_t b = a + 1; b < points_.size(); ++b) {
      const FinePoint from = points_[a].at;
      const FinePoint to = points_[b].at;
      if (!points_[a].isTangentTo(to) || !points_[b].isTangentTo(from)) continue;
      if (!free.canSee(from, to)) continue;
      const auto length = static_cast<float>(distancePx(points_[a].corner(), points_[b].corner()));
      edges_of[a].push_back({static_cast<Node>(b), length});
      edges_of[b].push_back({static_cast<Node>(a), length});
    }
  }
  edges_from_.push_back(0);
  for (const std::vector<Edge>& edges : edges_of) {
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    edges_from_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }
}

/// Where the free space is narrowed by less, what is seen from any place of a border is seen from
/// its middle: that place's sight, moved by up to the portal's reach.
RegionRoads::View RegionRoads::viewOf(const FreeSpace& free,
                                      const std::vector<const Portal*>& portals,
                                      std::size_t rank) const {
  const Portal& portal = *portals[rank];
  View view;
  for (std::size_t i = 0; i < nodeCount(); ++i) {
    if (i == points_.size() + rank) continue;
    const auto node = static_cast<Node>(i);
    const Portal* other = isTurningPoint(node) ? nullptr : portals[i - points_.size()];
    if (other == nullptr && !canBendTowards(points_[i], portal)) continue;
    // Straight there and back is a sight of the other region, too, wherever it passes.
    if (other != nullptr && leadToTheSame(portal, *other)) continue;
    const FinePoint there = at(node);
    const FinePoint end = other == nullptr ? points_[i].corner() : there;
    const bool seen = free.canSee(crossings_[rank], there);
    if (seen && (other != nullptr || points_[i].isTangentTo(crossings_[rank]))) {
      view.nodes.push_back({node, static_cast<float>(distancePx(crossings_[rank], end))});
    }
    const double reach = other == nullptr ? portal.reach : std::max(portal.reach, other->reach);
    if (!seen && !free.narrowedLess(reach + kTwoHalfDiagonals).canSee(crossings_[rank], there)) {
      continue;
    }
    const double least =
        other == nullptr ? portal.distanceToBorder(end) : portal.distanceToBorder(*other);
    view.nearly.push_back({node, static_cast<float>(least)});
  }
  return view;
}

void RegionRoads::findPaths(const std::vector<View>& views, std::size_t rank) {
  const Node root = nodeOfPortal(rank);
  std::vector<float> reached(nodeCount(), kUnreachable);
  std::vector<Node> next(nodeCount(), root);
  reached[root] = 0;
  for (const Edge& edge : views[rank].nodes) reached[edge.to] = edge.length;
  spread(reached, next);
  for (std::size_t other = 0; other < views.size(); ++other) {
    const Node there = nodeOfPortal(other);
    for (const Edge& edge : views[other].nodes) {
      if (!isTurningPoint(edge.to) || !(reached[edge.to] + edge.length < reached[there])) continue;
      reached[there] = reached[edge.to] + edge.length;
      next[there] = edge.to;
    }
  }
  path_.insert(path_.end(), reached.begin(), reached.end());
  next_.insert(next_.end(), next.begin(), next.end());
}

/// As findPaths, but from border to border. Also, no path between two places of the borders is
/// shorter than one between their middles by more than both reaches.
void RegionRoads::findLeast(const std::vector<const Portal*>& portals,
                            const std::vector<View>& views, std::size_t rank) {
  std::vector<float> reached(nodeCount(), kUnreachable);
  std::vector<Node> next(nodeCount());
  for (const Edge& edge : views[rank].nearly) reached[edge.to] = edge.length;
  spread(reached, next);
  const float* distance = lengthsTo(Measure::kPath, rank);
  for (std::size_t other = 0; other < views.size(); ++other) {
    const Node there = nodeOfPortal(other);
    for (const Edge& edge : views[other].nearly) {
      if (!isTurningPoint(edge.to)) continue;
      reached[there] = std::min(reached[there], reached[edge.to] + edge.length);
    }
    if (leadToTheSame(*portals[rank], *portals[other])) continue;
    const auto slack = static_cast<float>(portals[rank]->reach + portals[other]->reach);
    reached[there] = std::max(reached[there], distance[there] - slack);
  }
  reached[nodeOfPortal(rank)] = 0;
  least_.insert(least_.end(), reached.begin(), reached.end());
}

/// Dijkstra over the turning points, from what is reached already.
void RegionRoads::spread(std::vector<float>& reached, std::vector<Node>& next) const {
  using Entry = std::pair<float, Node>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (reached[i] < kUnreachable) open.emplace(reached[i], static_cast<Node>(i));
  }
  while (!open.empty()) {
    const auto [length, node] = open.top();
    open.pop();
    if (length > reached[node]) continue;
    for (const Edge* edge = edgesBegin(node); edge != edgesEnd(node); ++edge) {
      if (!(length + edge->length < reached[edge->to])) continue;
      reached[edge->to] = length + edge->length;
      next[edge->to] = node;
      open.emplace(reached[edge->to], edge->to);
    }
  }
}

}  // namespace agrid::planning
