// SPDX-License-Identifier: BSD-3-Clause
#include "planning/local_road.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace agrid::planning {
namespace {

using Node = RegionRoads::Node;
constexpr Node kNone = 0xffff;

/// A leg to a node: from the start, from another node, or (to kNone) from a node to the goal. Legs
/// that begin or end at a path's end are looked along when they are taken.
struct Leg {
  float estimate;  ///< of the whole path
  float length;    ///< of the path up to here
  Node to;
  Node from;

  bool operator>(const Leg& other) const { return estimate > other.estimate; }
};

class LocalSearch {
 public:
  LocalSearch(RoadEnd& start, RoadEnd& goal)
      : start_(start),
        goal_(goal),
        roads_(start.roads()),
        parent_(roads_.points().size(), kNone),
        done_(parent_.size()) {}

  LocalRoad find() {
    for (Node node = 0; node < parent_.size(); ++node) push(start_.hopedSight(node), node, kNone);
    LocalRoad road;
    while (!open_.empty()) {
      const Leg leg = open_.top();
      open_.pop();
      if (leg.to == kNone) {
        if (!goal_.canSee(leg.from)) continue;
        road.length = leg.length;
        for (Node node = leg.from; node != kNone; node = parent_[node]) road.nodes.push_back(node);
        std::reverse(road.nodes.begin(), road.nodes.end());
        return road;
      }
      if (done_[leg.to] || (leg.from == kNone && !start_.canSee(leg.to))) continue;
      expand(leg);
    }
    return road;
  }

 private:
  void push(float length, Node to, Node from) {
    if (length == kUnreachable) return;
    const auto rest = static_cast<float>(distancePx(roads_.points()[to].corner(), goal_.point()));
    open_.push({length + rest, length, to, from});
  }
  void expand(const Leg& leg) {
    done_[leg.to] = true;
    parent_[leg.to] = leg.from;
    const float to_goal = goal_.hopedSight(leg.to);
    if (to_goal < kUnreachable) {
      open_.push({leg.length + to_goal, leg.length + to_goal, kNone, leg.to});
    }
    for (const auto* edge = roads_.edgesBegin(leg.to); edge != roads_.edgesEnd(leg.to); ++edge) {
      if (!done_[edge->to]) push(leg.length + edge->length, edge->to, leg.to);
    }
  }

  RoadEnd& start_;
  RoadEnd& goal_;
  const RegionRoads& roads_;
  std::vector<Node> parent_;
  std::vector<bool> done_;
  std::priority_queue<Leg, std::vector<Leg>, std::greater<>> open_;
};

}  // namespace

LocalRoad findLocalRoad(RoadEnd& start, RoadEnd& goal) { return LocalSearch(start, goal).find(); }

}  // namespace agrid::planning
