// SPDX-License-Identifier: BSD-3-Clause
#include "planning/known_sights.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace agrid::planning {
namespace {

bool isSame(const Portal& a, const Portal& b) {
  return a.middle == b.middle && a.beyond == b.beyond && a.border.low == b.border.low &&
         a.border.high == b.border.high && a.reach == b.reach && a.straight == b.straight;
}

/// Whether a segment may touch a box of pixels.
bool mayTouch(const Point2& a, const Point2& b, const PixelBox& box) {
  const Point2 low(box.low.x - 1.0, box.low.y - 1.0);
  const Point2 high(box.high.x + 1.0, box.high.y + 1.0);
  for (int axis = 0; axis < 2; ++axis) {
    if (std::max(a[axis], b[axis]) < low[axis] || std::min(a[axis], b[axis]) > high[axis]) {
      return false;
    }
  }
  const Point2 along = b - a;
  const auto side = [&](double x, double y) {
    return along.x() * (y - a.y()) - along.y() * (x - a.x());
  };
  const auto [least, greatest] = std::minmax({side(low.x(), low.y()), side(low.x(), high.y()),
                                              side(high.x(), low.y()), side(high.x(), high.y())});
  return least <= 0 && greatest >= 0;
}

}  // namespace

KnownSights::KnownSights(const FormerRegion& former, std::uint32_t region,
                         const std::vector<TurningPoint>& points,
                         const std::vector<const Portal*>& portals)
    : former_(&former), point_count_(points.size()) {
  const RegionRoads& roads = *former.roads;
  std::map<std::tuple<std::int64_t, std::int64_t, int, int>, Node> known;
  const auto keyOf = [](const TurningPoint& point) {
    return std::tuple(point.at.x, point.at.y, int{point.blocked_x}, int{point.blocked_y});
  };
  for (std::size_t i = 0; i < roads.points().size(); ++i) {
    known.emplace(keyOf(roads.points()[i]), static_cast<Node>(i));
  }
  for (const TurningPoint& point : points) {
    const auto found = known.find(keyOf(point));
    former_node_.push_back(found == known.end() ? kUnknown : found->second);
    places_.push_back(point.at);
  }
  for (const Portal* portal : portals) {
    const auto found =
        std::find_if(former.portals.begin(), former.portals.end(), [&](const Portal* other) {
          return isSame(*portal, *other) && portal->sideOf(region) == other->sideOf(former.region);
        });
    const auto rank = static_cast<std::size_t>(found - former.portals.begin());
    former_node_.push_back(found == former.portals.end() ? kUnknown : roads.nodeOfPortal(rank));
    places_.push_back(portal->crossing());
  }
  const std::size_t count = roads.points().size();
  edges_.resize(count * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto node = static_cast<Node>(i);
    for (const auto* edge = roads.edgesBegin(node); edge != roads.edgesEnd(node); ++edge) {
      edges_[i * count + edge->to] = true;
    }
  }
}

bool KnownSights::isUnchangedBetween(FinePoint a, FinePoint b) const {
  return std::none_of(former_->changed.begin(), former_->changed.end(), [&](const PixelBox& box) {
    return mayTouch(coordinates(a), coordinates(b), box);
  });
}

std::optional<bool> KnownSights::edge(std::size_t a, std::size_t b) const {
  if (former_ == nullptr || former_node_[a] == kUnknown || former_node_[b] == kUnknown ||
      !isUnchangedBetween(places_[a], places_[b])) {
    return std::nullopt;
  }
  return edges_[former_node_[a] * former_->roads->points().size() + former_node_[b]];
}

std::optional<Sights> KnownSights::from(std::size_t portal, std::size_t node) const {
  if (former_ == nullptr) return std::nullopt;
  const Node from = former_node_[point_count_ + portal];
  const Node to = former_node_[node];
  if (from == kUnknown || to == kUnknown ||
      !isUnchangedBetween(places_[point_count_ + portal], places_[node])) {
    return std::nullopt;
  }
  const std::size_t rank = from - former_->roads->points().size();
  const Sights sights = former_->roads->sights(rank, to);
  if (!sights.looked) return std::nullopt;
  return sights;
}

}  // namespace agrid::planning
