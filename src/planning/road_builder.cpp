// SPDX-License-Identifier: BSD-3-Clause
#include "planning/road_builder.h"

namespace agrid::planning {
namespace {

using Node = RegionRoads::Node;

/// Places of a crossing's portal among those of the region that it leaves and enters.
std::size_t rankLeaving(const Roadmap& roadmap, const Crossing& crossing) {
  return roadmap.rankOf(crossing.portal, 1 - crossing.side);
}
std::size_t rankEntering(const Roadmap& roadmap, const Crossing& crossing) {
  return roadmap.rankOf(crossing.portal, crossing.side);
}

}  // namespace

RoadBuilder::RoadBuilder(const Roadmap& roadmap, RoadEnd& start)
    : roadmap_(roadmap), start_(start) {
  road_.regions.push_back(start.region());
  push(start.point(), 0, 0);
}

void RoadBuilder::goThrough(const std::vector<Crossing>& way) {
  const Crossing* previous = nullptr;
  for (const Crossing& crossing : way) {
    const RegionRoads& roads = roadmap_.roads(road_.regions.back());
    const std::size_t rank = rankLeaving(roadmap_, crossing);
    const Node node = previous == nullptr
                          ? start_.next(rank)
                          : roads.next(rank, roads.nodeOfPortal(rankEntering(roadmap_, *previous)));
    follow(roads, rank, node);
    road_.regions.push_back(roadmap_.regions().portals()[crossing.portal].nodes[crossing.side]);
    previous = &crossing;
  }
}

void RoadBuilder::goTo(RoadEnd& goal, const Crossing& last) {
  const RegionRoads& roads = goal.roads();
  const std::size_t rank = rankEntering(roadmap_, last);
  std::vector<Node> nodes;
  for (Node node = goal.next(rank); roads.isTurningPoint(node); node = roads.next(rank, node)) {
    nodes.push_back(node);
  }
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) add(roads, *node);
  push(goal.point(), 0, 0);
}

void RoadBuilder::goInto(const RoadGoal& goal, const Portal& border, Pixel first) {
  const FinePoint from = road_.corners[road_.corners.size() - 2].at;
  push(goal.placeBeside(border, first, from), 0, 0);
}

void RoadBuilder::goAround(const std::vector<Node>& nodes, FinePoint goal) {
  for (const Node node : nodes) add(start_.roads(), node);
  push(goal, 0, 0);
}

/// From a node to the middle of a portal.
void RoadBuilder::follow(const RegionRoads& roads, std::size_t rank, Node node) {
  for (; roads.isTurningPoint(node); node = roads.next(rank, node)) add(roads, node);
  push(roads.at(roads.nodeOfPortal(rank)), 0, 0);
}

void RoadBuilder::add(const RegionRoads& roads, Node node) {
  const TurningPoint& point = roads.points()[node];
  push(point.at, point.blocked_x, point.blocked_y);
}

void RoadBuilder::push(FinePoint at, std::int8_t blocked_x, std::int8_t blocked_y) {
  const auto region = static_cast<std::uint32_t>(road_.regions.size() - 1);
  road_.corners.push_back({at, blocked_x, blocked_y, region, region});
}

}  // namespace agrid::planning
