// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/lead_roadmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include <ompl/base/PlannerData.h>
#include <ompl/base/spaces/RealVectorBounds.h>

namespace agrid::planning {
namespace {

namespace ob = ompl::base;

constexpr double kPi = 3.14159265358979323846;
/// Motions longer than so many scales are not tried between poses of the roadmap ...
constexpr double kReach = 10;
/// ... and no more than these many from a pose to poses that are new since it was last linked.
constexpr std::size_t kMaxLinks = 40;
/// The search goes for the goal a little faster than the lead's length justifies: its paths are
/// shortened anyway.
constexpr double kHaste = 1.15;
constexpr double kPosesPerScale = 3;
constexpr std::size_t kFewestPoses = 60;
constexpr std::size_t kMostPoses = 1000;

}  // namespace

/// A* that checks a motion only when it is taken off the queue.
class LeadRoadmap::Search {
 public:
  explicit Search(LeadRoadmap& map) : map_(map), parents_(map.nodes_.size(), kNone) {}

  /// @return the nodes from a start to a goal; none if there is no path yet or it was stopped
  std::vector<std::uint32_t> run(const ob::PlannerTerminationCondition& stop) {
    least_ = std::numeric_limits<double>::infinity();
    for (const std::uint32_t start : map_.starts_) push(0, start, start, 0);
    while (!queue_.empty()) {
      if (stop) return {};
      const Entry entry = queue_.top();
      queue_.pop();
      if (parents_[entry.node] != kNone || !isFree(entry)) continue;
      parents_[entry.node] = entry.parent;
      least_ = std::min(least_, map_.nodes_[entry.node].remaining);
      if (map_.nodes_[entry.node].is_goal) return wayTo(entry.node);
      expand(entry);
    }
    return {};
  }
  /// Way along the lead that was left at the nearest pose reached [m].
  double least() const { return least_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Entry {
    double estimate;
    double length;
    std::uint32_t node;
    std::uint32_t parent;
    std::uint32_t edge;
    bool operator<(const Entry& other) const {
      return std::tie(other.estimate, other.node, other.parent) < std::tie(estimate, node, parent);
    }
  };

  void push(double length, std::uint32_t node, std::uint32_t parent, std::uint32_t edge) {
    const double estimate = length + kHaste * map_.nodes_[node].remaining;
    queue_.push({estimate, length, node, parent, edge});
  }
  void expand(const Entry& entry) {
    map_.link(entry.node);
    const auto& edges = map_.nodes_[entry.node].edges;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (edges[i].check == Check::kBlocked || parents_[edges[i].to] != kNone) continue;
      push(entry.length + edges[i].length, edges[i].to, entry.node, i);
    }
  }
  bool isFree(const Entry& entry) {
    if (entry.node == entry.parent) return true;
    Node& from = map_.nodes_[entry.parent];
    Edge& edge = from.edges[entry.edge];
    if (edge.check == Check::kNotYet) {
      const bool free = map_.space_->checkMotion(from.state, map_.nodes_[entry.node].state);
      edge.check = free ? Check::kFree : Check::kBlocked;
    }
    return edge.check == Check::kFree;
  }
  std::vector<std::uint32_t> wayTo(std::uint32_t node) const {
    std::vector<std::uint32_t> way{node};
    while (parents_[way.back()] != way.back()) way.push_back(parents_[way.back()]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  LeadRoadmap& map_;
  std::vector<std::uint32_t> parents_;  ///< of nodes that were reached; starts are their own
  std::priority_queue<Entry> queue_;
  double least_ = 0;
};

LeadRoadmap::LeadRoadmap(ob::SpaceInformationPtr space, LeadPath lead, double scale,
                         std::uint32_t seed)
    : space_(std::move(space)),
      motions_(space_->getStateSpace()),
      lead_(std::move(lead)),
      samples_(lead_, scale, seed),
      reach_(kReach * scale) {}

LeadRoadmap::~LeadRoadmap() {
  for (const Node& node : nodes_) space_->freeState(node.state);
}

void LeadRoadmap::addStart(const ob::State* state) {
  addNode(space_->cloneState(state), 0);
  starts_.push_back(static_cast<std::uint32_t>(nodes_.size() - 1));
}

void LeadRoadmap::addGoal(const ob::State* state) {
  addNode(space_->cloneState(state), lead_.length());
  nodes_.back().is_goal = true;
}

void LeadRoadmap::addNode(ob::State* owned, double along) {
  Node node;
  node.state = owned;
  node.pose = motions_.pose(owned);
  node.remaining = lead_.length() - along;
  nodes_.push_back(std::move(node));
}

void LeadRoadmap::add(const Pose2& pose, double along) {
  ob::State* state = space_->allocState();
  motions_.set(state, pose);
  if (space_->satisfiesBounds(state) && space_->isValid(state)) {
    addNode(state, along);
  } else {
    space_->freeState(state);
  }
}

void LeadRoadmap::addUniform() {
  const ob::RealVectorBounds& box = motions_.bounds();
  ompl::RNG& random = samples_.random();
  Pose2 pose;
  for (int i = 0; i < 2; ++i)
    pose.position[i] = random.uniformReal(box.low[static_cast<std::size_t>(i)],
                                          box.high[static_cast<std::size_t>(i)]);
  pose.yaw = random.uniformReal(-kPi, kPi);
  add(pose, lead_.nearest(pose.position));
}

void LeadRoadmap::addLeadItself() {
  struct Bend {
    double around;   ///< way over which the corner is rounded
    double outside;  ///< distance from the corner, which may touch what is not free
  };
  const double scale = samples_.scale();
  const std::vector<Point2>& corners = lead_.corners();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point2 inwards =
        (corners[i + 1] - corners[i]).normalized() + (corners[i - 1] - corners[i]).normalized();
    const Point2 outwards = inwards.norm() > 1e-9 ? Point2(-inwards.normalized()) : Point2(0, 0);
    const double along = lead_.lengthAt(i);
    for (const Bend& bend :
         {Bend{0.1, 0}, Bend{0.1, 0.005}, Bend{1, 0.005}, Bend{1, 0.03}, Bend{2, 0.1}}) {
      add({corners[i] + bend.outside * scale * outwards,
           lead_.heading(along, bend.around * scale, bend.around * scale)},
          along);
    }
  }
}

void LeadRoadmap::grow(const ob::PlannerTerminationCondition& stop) {
  const double wanted = kPosesPerScale * lead_.length() / samples_.scale();
  const auto size =
      static_cast<std::size_t>(std::clamp(wanted, double{kFewestPoses}, double{kMostPoses}));
  if (rounds_ == 0) addLeadItself();
  for (std::size_t i = 0; i < size && !stop; ++i) {
    const double share = samples_.random().uniform01();
    if (rounds_ > 0 && share < 0.1) {
      addUniform();
    } else {
      const bool at_stuck = rounds_ > 0 && share < 0.6;
      const double along = at_stuck ? samples_.random().gaussian(stuck_, 2 * samples_.scale())
                                    : samples_.random().uniformReal(0, lead_.length());
      const double on_lead = std::clamp(along, 0.0, lead_.length());
      add(samples_.near(on_lead), on_lead);
    }
  }
  ++rounds_;
}

void LeadRoadmap::link(std::size_t index) {
  Node& node = nodes_[index];
  std::vector<std::pair<double, std::uint32_t>> near;
  for (std::size_t i = node.linked; i < nodes_.size(); ++i) {
    const double distance = (nodes_[i].pose.position - node.pose.position).norm();
    if (distance > reach_ || i == index) continue;
    const double turned = std::abs(std::remainder(nodes_[i].pose.yaw - node.pose.yaw, 2 * kPi));
    near.push_back({distance + samples_.scale() * turned, static_cast<std::uint32_t>(i)});
  }
  node.linked = nodes_.size();
  const std::size_t kept = std::min(near.size(), kMaxLinks);
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
  for (std::size_t i = 0; i < kept; ++i) {
    const std::uint32_t to = near[i].second;
    const double length = space_->distance(node.state, nodes_[to].state);
    if (std::isfinite(length)) node.edges.push_back({to, Check::kNotYet, length});
  }
}

std::vector<const ob::State*> LeadRoadmap::solve(const ob::PlannerTerminationCondition& stop,
                                                 int rounds) {
  std::vector<const ob::State*> path;
  for (int i = 0; i < rounds && path.empty() && !stop; ++i) {
    grow(stop);
    Search search(*this);
    for (const std::uint32_t node : search.run(stop)) path.push_back(nodes_[node].state);
    stuck_ = lead_.length() - std::min(search.least(), lead_.length());
  }
  return path;
}

void LeadRoadmap::getData(ob::PlannerData& data) const {
  for (const std::uint32_t start : starts_) {
    data.addStartVertex(ob::PlannerDataVertex(nodes_[start].state));
  }
  for (const Node& node : nodes_) {
    if (node.is_goal) data.addGoalVertex(ob::PlannerDataVertex(node.state));
  }
  for (const Node& node : nodes_) {
    for (const Edge& edge : node.edges) {
      if (edge.check != Check::kFree) continue;
      data.addEdge(ob::PlannerDataVertex(node.state), ob::PlannerDataVertex(nodes_[edge.to].state));
    }
  }
}

}  // namespace agrid::planning
