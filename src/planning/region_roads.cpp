// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_roads.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

#include "planning/known_sights.h"

namespace agrid::planning {
namespace {

using Node = RegionRoads::Node;
using Edge = RegionRoads::Edge;

/// Whether a shortest path from anywhere on the portal's border can bend at the point.
bool canBendTowards(const TurningPoint& point, const Portal& portal) {
  const PixelBox& b = portal.border;
  return point.isTangentTo(portal.crossing()) || point.isTangentTo(lowerCornerOf(b.low)) ||
         point.isTangentTo(lowerCornerOf({b.high.x, b.low.y})) ||
         point.isTangentTo(lowerCornerOf({b.low.x, b.high.y})) ||
         point.isTangentTo(lowerCornerOf(b.high));
}

Sights sightsBetween(const FreeSpace& free, const FreeSpace& wider, FinePoint a, FinePoint b) {
  const bool seen = free.canSee(a, b);
  return {true, seen, seen || wider.canSee(a, b)};
}

/// Whether two portals of a region lead to the same other one.
bool leadToTheSame(const Portal& a, const Portal& b) {
  return std::minmax({a.nodes[0], a.nodes[1]}) == std::minmax({b.nodes[0], b.nodes[1]});
}

}  // namespace

RegionRoads::RegionRoads(const FreeSpace& free, std::uint32_t region,
                         std::vector<TurningPoint> points,
                         const std::vector<const Portal*>& portals, const FormerRegion* former)
    : region_(region), points_(std::move(points)) {
  for (const Portal* portal : portals) crossings_.push_back(portal->crossing());
  const KnownSights known =
      former == nullptr ? KnownSights() : KnownSights(*former, region, points_, portals);
  findEdges(free, known);
  const std::vector<View> views = findViews(free, portals, known);
  path_.reserve(portals.size() * nodeCount());
  least_.reserve(portals.size() * nodeCount());
  next_.reserve(portals.size() * nodeCount());
  for (std::size_t i = 0; i < portals.size(); ++i) {
    findPaths(views, i);
    findLeast(portals, views, i);
  }
}

void RegionRoads::findEdges(const FreeSpace& free, const KnownSights& known) {
  std::vector<std::vector<Edge>> edges_of(points_.size());
  for (std::size_t a = 0; a < points_.size(); ++a) {
    for (std::size_t b = a + 1; b < points_.size(); ++b) {
      const FinePoint from = points_[a].at;
      const FinePoint to = points_[b].at;
      if (!points_[a].isTangentTo(to) || !points_[b].isTangentTo(from)) continue;
      const std::optional<bool> seen = known.edge(a, b);
      if (!(seen ? *seen : free.canSee(from, to))) continue;
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

std::vector<RegionRoads::View> RegionRoads::findViews(const FreeSpace& free,
                                                      const std::vector<const Portal*>& portals,
                                                      const KnownSights& known) {
  const Look look{free, portals, known};
  std::vector<View> views(portals.size());
  sights_.resize(portals.size() * nodeCount());
  for (std::size_t i = 0; i < portals.size(); ++i) {
    lookAtPoints(look, i, views[i]);
    for (std::size_t j = i + 1; j < portals.size(); ++j) {
      // Straight there and back is a sight of the other region, too, wherever it passes.
      if (!leadToTheSame(*portals[i], *portals[j])) lookAtPortal(look, {i, j}, views);
    }
  }
  return views;
}

/// Where the free space is narrowed by less, what is seen from any place of a border is seen from
/// its middle: that place's sight, moved by up to the portal's reach.
void RegionRoads::lookAtPoints(const Look& look, std::size_t rank, View& view) {
  const Portal& portal = *look.portals[rank];
  const FreeSpace wider = look.free.narrowedLess(portal.reach + kTwoHalfDiagonals);
  const FinePoint from = portal.crossing();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const TurningPoint& point = points_[i];
    if (!portal.canLeadTo(point.corner(), region_) || !canBendTowards(point, portal)) continue;
    const auto node = static_cast<Node>(i);
    const std::optional<Sights> known = look.known.from(rank, i);
    const Sights sights = known ? *known : sightsBetween(look.free, wider, from, point.at);
    sights_[rank * nodeCount() + i] = sights;
    if (sights.seen && point.isTangentTo(from)) {
      view.nodes.push_back({node, static_cast<float>(distancePx(from, point.corner()))});
    }
    if (sights.nearly) {
      view.nearly.push_back({node, static_cast<float>(portal.distanceToBorder(point.corner()))});
    }
  }
}

void RegionRoads::lookAtPortal(const Look& look, std::array<std::size_t, 2> ranks,
                               std::vector<View>& views) {
  const Portal& a = *look.portals[ranks[0]];
  const Portal& b = *look.portals[ranks[1]];
  const FinePoint from = a.crossing();
  const FinePoint to = b.crossing();
  // Anywhere on the other border, hence the border's ends.
  if (!a.canLeadToBorder(b, region_) || !b.canLeadToBorder(a, region_)) return;
  const FreeSpace wider = look.free.narrowedLess(std::max(a.reach, b.reach) + kTwoHalfDiagonals);
  const std::optional<Sights> known = look.known.from(ranks[0], nodeOfPortal(ranks[1]));
  const Sights sights = known ? *known : sightsBetween(look.free, wider, from, to);
  const auto length = static_cast<float>(distancePx(from, to));
  const auto least = static_cast<float>(a.distanceToBorder(b));
  for (const std::size_t i : {0U, 1U}) {
    const Node node = nodeOfPortal(ranks[1 - i]);
    sights_[ranks[i] * nodeCount() + node] = sights;
    if (sights.seen) views[ranks[i]].nodes.push_back({node, length});
    if (sights.nearly) views[ranks[i]].nearly.push_back({node, least});
  }
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
/// shorter than one between their middles by more than both reaches. That says nothing of a path
/// that leads back over the same border, which bends on the way: the middles may see each other,
/// which is no path here, where other places do not.
void RegionRoads::findLeast(const std::vector<const Portal*>& portals,
                            const std::vector<View>& views, std::size_t rank) {
  const float* distance = lengthsTo(Measure::kPath, rank);
  std::vector<float> reached(nodeCount(), kUnreachable);
  std::vector<Node> next(nodeCount());
  for (const Edge& edge : views[rank].nearly) reached[edge.to] = edge.length;
  spread(reached, next);
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
