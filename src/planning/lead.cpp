// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lead.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace agrid::planning {
namespace {

/// Ways through the portals' middles that are so much longer than the shortest one are still led
/// along: the middles misjudge a way by about the portals' widths.
constexpr double kDetourFactor = 1.002;
constexpr double kDetourPx = 1;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double gap(double low_a, double high_a, double low_b, double high_b) {
  return std::max({0.0, low_b - high_a, low_a - high_b});
}

/// Distance between the boxes' outlines, pixels being squares.
double boxDistance(const PixelBox& a, const PixelBox& b) {
  return std::hypot(gap(a.low.x - 0.5, a.high.x + 0.5, b.low.x - 0.5, b.high.x + 0.5),
                    gap(a.low.y - 0.5, a.high.y + 0.5, b.low.y - 0.5, b.high.y + 0.5));
}

double boxDistance(const PixelBox& box, FinePoint point) {
  const Point2 p = coordinates(point);
  return std::hypot(gap(box.low.x - 0.5, box.high.x + 0.5, p.x(), p.x()),
                    gap(box.low.y - 0.5, box.high.y + 0.5, p.y(), p.y()));
}

struct Seed {
  std::uint32_t portal;
  double cost;
};

/// A search over the portals from `seeds`; `end_cost` says what a way that ends at a portal costs
/// (infinity: it can't end there), `remaining` bounds from below what comes after a portal.
struct PortalSearch {
  const PortalGraph* graph = nullptr;
  const StopCheck* stop = nullptr;
  std::function<double(std::uint32_t, std::uint32_t)> cost;
  std::function<double(std::uint32_t)> remaining;
  std::function<double(std::uint32_t)> end_cost;
  std::function<double(double)> limit;  ///< how far to go beyond the best way found

  std::vector<double> reached;  ///< cost of the best way to each portal
  double best = kInfinity;      ///< cost of the best way to an end

  void run(const std::vector<Seed>& seeds);
};

void PortalSearch::run(const std::vector<Seed>& seeds) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  reached.assign(graph->portals().size(), kInfinity);
  std::vector<bool> done(reached.size());
  const auto push = [&](std::uint32_t portal, double value) {
    if (!(value < reached[portal])) return;
    reached[portal] = value;
    open.emplace(value + remaining(portal), portal);
  };
  for (const Seed& seed : seeds) push(seed.portal, seed.cost);
  for (std::size_t i = 0; !open.empty() && open.top().first <= limit(best); ++i) {
    if (i % 1024 == 0) stop->check();
    const std::uint32_t portal = open.top().second;
    open.pop();
    if (done[portal]) continue;
    done[portal] = true;
    best = std::min(best, reached[portal] + end_cost(portal));
    for (const std::uint32_t node : graph->portals()[portal].nodes) {
      for (const std::uint32_t next : graph->portalsOf(node)) {
        if (!done[next]) push(next, reached[portal] + cost(portal, next));
      }
    }
  }
}

class LeadSearch {
 public:
  LeadSearch(const PortalGraph& graph, FinePoint start, std::uint32_t start_node,
             const Target& target, const StopCheck& stop)
      : graph_(graph), start_(start), start_node_(start_node), target_(target), stop_(stop) {}

  Lead find() const {
    Lead lead;
    lead.length_bound_px = lengthBound();
    if (isTargetNode(start_node_) &&
        graph_.portalsOf(start_node_).begin() == graph_.portalsOf(start_node_).end()) {
      lead.nodes = {start_node_};
      return lead;
    }
    lead.nodes = nodesOnShortWays();
    return lead;
  }

 private:
  const Portal& portal(std::uint32_t i) const { return graph_.portals()[i]; }
  FinePoint middle(std::uint32_t i) const { return centerOf(portal(i).middle); }
  bool isTargetNode(std::uint32_t node) const {
    return std::binary_search(target_.nodes.begin(), target_.nodes.end(), node);
  }
  bool touchesTarget(std::uint32_t i) const {
    return isTargetNode(portal(i).nodes[0]) || isTargetNode(portal(i).nodes[1]);
  }

  /// The shortest way from portal to portal when each step is as short as their boxes allow: every
  /// path passes those portals in its order, so that none is shorter.
  double lengthBound() const {
    const double straight = target_.distanceFrom(start_);
    if (isTargetNode(start_node_)) return straight;
    PortalSearch search{&graph_, &stop_, {}, {}, {}, {}, {}, kInfinity};
    search.cost = [&](std::uint32_t a, std::uint32_t b) {
      return boxDistance(portal(a).box, portal(b).box);
    };
    const auto to_target = [&](std::uint32_t i) {
      return target_.point ? boxDistance(portal(i).box, *target_.point)
                           : boxDistance(portal(i).box, target_.box);
    };
    search.remaining = to_target;
    search.end_cost = [&](std::uint32_t i) { return touchesTarget(i) ? to_target(i) : kInfinity; };
    search.limit = [](double best) { return best; };
    std::vector<Seed> seeds;
    for (const std::uint32_t i : graph_.portalsOf(start_node_)) {
      seeds.push_back({i, boxDistance(portal(i).box, start_)});
    }
    search.run(seeds);
    return std::max(straight, search.best);
  }

  PortalSearch throughMiddles() const {
    PortalSearch search{&graph_, &stop_, {}, {}, {}, {}, {}, kInfinity};
    search.cost = [&](std::uint32_t a, std::uint32_t b) {
      return distancePx(middle(a), middle(b));
    };
    return search;
  }

  PortalSearch fromStart() const {
    PortalSearch search = throughMiddles();
    search.remaining = [&](std::uint32_t i) { return target_.distanceFrom(middle(i)); };
    search.end_cost = [&](std::uint32_t i) {
      return touchesTarget(i) ? target_.distanceFrom(middle(i)) : kInfinity;
    };
    search.limit = [](double best) { return kDetourFactor * best + kDetourPx; };
    if (isTargetNode(start_node_)) search.best = target_.distanceFrom(start_);
    std::vector<Seed> seeds;
    for (const std::uint32_t i : graph_.portalsOf(start_node_)) {
      seeds.push_back({i, distancePx(start_, middle(i))});
    }
    search.run(seeds);
    return search;
  }

  PortalSearch fromTarget(double limit) const {
    PortalSearch search = throughMiddles();
    search.remaining = [&](std::uint32_t i) { return distancePx(start_, middle(i)); };
    search.end_cost = [](std::uint32_t) { return kInfinity; };
    search.limit = [limit](double) { return limit; };
    std::vector<Seed> seeds;
    for (const std::uint32_t node : target_.nodes) {
      for (const std::uint32_t i : graph_.portalsOf(node)) {
        seeds.push_back({i, target_.distanceFrom(middle(i))});
      }
    }
    search.run(seeds);
    return search;
  }

  std::vector<std::uint32_t> nodesOnShortWays() const {
    const PortalSearch forward = fromStart();
    // The best way itself must pass in spite of rounding, hence the last term.
    const double limit = forward.limit(forward.best) + 1e-6 * forward.best;
    const PortalSearch backward = fromTarget(limit);
    std::vector<std::uint32_t> nodes{start_node_};
    for (std::uint32_t i = 0; i < forward.reached.size(); ++i) {
      if (forward.reached[i] + backward.reached[i] > limit) continue;
      nodes.push_back(portal(i).nodes[0]);
      nodes.push_back(portal(i).nodes[1]);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  const PortalGraph& graph_;
  FinePoint start_;
  std::uint32_t start_node_;
  const Target& target_;
  const StopCheck& stop_;
};

}  // namespace

double Target::distanceFrom(FinePoint p) const {
  return point ? distancePx(p, *point) : boxDistance(box, p);
}

Lead findLead(const PortalGraph& graph, FinePoint start, std::uint32_t start_node,
              const Target& target, const StopCheck& stop) {
  return LeadSearch(graph, start, start_node, target, stop).find();
}

}  // namespace agrid::planning
