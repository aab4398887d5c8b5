// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "planning/free_space.h"
#include "planning/portal_graph.h"
#include "planning/turning_point.h"

namespace agrid::planning {

constexpr float kUnreachable = std::numeric_limits<float>::infinity();

/// A path crosses a portal anywhere on its border.
enum class Measure {
  kPath,  ///< length of the shortest path that passes the middle of the border
  kLeast  ///< no path to any place of the border is shorter
};

/// What was seen of a node from a portal's middle; one byte, since there are as many as pairs of
/// them.
struct Sights {
  bool looked : 1;
  bool seen : 1;
  bool nearly : 1;  ///< seen, or where the free space is wider by the portal's reach
};
struct FormerRegion;
class KnownSights;

/// The shortest paths within one region: between the portals on its border, and from any of its
/// turning points to them. A visibility graph of the turning points (Lozano-Perez and Wesley 1979),
/// with only the edges along which a shortest path can bend at both ends, and a shortest-path tree
/// for each portal. Lengths in pixels.
class RegionRoads {
 public:
  /// Nodes are numbered through: turning points first, then portals.
  using Node = std::uint16_t;

  struct Edge {
    Node to;
    float length;
  };

  RegionRoads() = default;
  /// @param region  its node in the portals' graph
  /// @param points  all turning points within reach of the region's paths
  /// @param portals  of the region; fewer than 65536 nodes in all
  /// @param former  spares looking where free space is as it was there
  RegionRoads(const FreeSpace& free, std::uint32_t region, std::vector<TurningPoint> points,
              const std::vector<const Portal*>& portals, const FormerRegion* former = nullptr);

  const std::vector<TurningPoint>& points() const { return points_; }
  std::size_t portalCount() const { return crossings_.size(); }
  FinePoint at(Node node) const {
    return node < points_.size() ? points_[node].at : crossings_[node - points_.size()];
  }
  bool isTurningPoint(Node node) const { return node < points_.size(); }
  Node nodeOfPortal(std::size_t portal) const { return static_cast<Node>(points_.size() + portal); }

  /// From each node to a portal; kUnreachable if the region has no path.
  const float* lengthsTo(Measure measure, std::size_t portal) const {
    return (measure == Measure::kPath ? path_ : least_).data() + portal * nodeCount();
  }
  /// The node after `node` on the path to the middle of a portal.
  Node next(std::size_t portal, Node node) const { return next_[portal * nodeCount() + node]; }

  Sights sights(std::size_t portal, Node node) const {
    return sights_[portal * nodeCount() + node];
  }

  /// From a turning point to others.
  const Edge* edgesBegin(Node node) const { return edges_.data() + edges_from_[node]; }
  const Edge* edgesEnd(Node node) const { return edges_.data() + edges_from_[node + 1U]; }

 private:
  /// What is seen of a portal.
  struct View {
    std::vector<Edge> nodes;   ///< from its middle
    std::vector<Edge> nearly;  ///< from anywhere on its border, and perhaps more; least lengths
  };
  struct Look {
    const FreeSpace& free;
    const std::vector<const Portal*>& portals;
    const KnownSights& known;
  };
  std::size_t nodeCount() const { return points_.size() + crossings_.size(); }
  void findEdges(const FreeSpace& free, const KnownSights& known);
  std::vector<View> findViews(const FreeSpace& free, const std::vector<const Portal*>& portals,
                              const KnownSights& known);
  void lookAtPoints(const Look& look, std::size_t rank, View& view);
  void lookAtPortal(const Look& look, std::array<std::size_t, 2> ranks, std::vector<View>& views);
  void findPaths(const std::vector<View>& views, std::size_t rank);
  void findLeast(const std::vector<const Portal*>& portals, const std::vector<View>& views,
                 std::size_t rank);
  void spread(std::vector<float>& reached, std::vector<Node>& next) const;

  std::uint32_t region_ = kNoNode;
  std::vector<TurningPoint> points_;
  std::vector<FinePoint> crossings_;
  std::vector<std::uint32_t> edges_from_;
  std::vector<Edge> edges_;
  std::vector<float> path_;     ///< portals x nodes
  std::vector<float> least_;    ///< portals x nodes
  std::vector<Node> next_;      ///< portals x nodes
  std::vector<Sights> sights_;  ///< portals x nodes
};

}  // namespace agrid::planning
