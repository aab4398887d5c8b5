// SPDX-License-Identifier: BSD-3-Clause
#include "tags/border_merging.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "tags/disjoint_sets.h"
#include "tags/separation.h"

namespace agrid {
namespace {

/// Borders below these shares of min_separation are opened, one level after the other.
constexpr std::array<double, 7> kLevels{0.03, 0.07, 0.15, 0.3, 0.5, 0.75, 1};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

class Merger {
 public:
  explicit Merger(RegionGraph graph)
      : graph_(std::move(graph)), sets_(graph_.size()), is_alive_(graph_.size(), true) {
    for (std::uint32_t region = 0; region < graph_.size(); ++region) judge(region);
  }

  void openBordersBelow(double level) {
    while (openOnce(level)) {
    }
  }

  /// Lets small regions join a neighbour, the smallest first.
  template <typename Predicate>
  void joinWhere(Predicate is_small) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t region = 0; region < graph_.size(); ++region) {
      if (is_alive_[region] && is_small(graph_.shape(region))) order.push_back(region);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return graph_.shape(a).size < graph_.shape(b).size;
    });
    for (const std::uint32_t region : order) {
      while (is_alive_[region] && is_small(graph_.shape(region)) && graph_.hasNeighbour(region)) {
        judge(merge(leastParted(region)));
      }
    }
  }

  std::vector<std::uint32_t> result() {
    std::vector<std::uint32_t> region_of(graph_.size());
    for (std::uint32_t i = 0; i < region_of.size(); ++i) region_of[i] = sets_.find(i);
    return region_of;
  }

 private:
  static Pair ordered(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

  void judge(std::uint32_t region) {
    graph_.forEachNeighbour(region, [&](std::uint32_t neighbour) {
      separation_[ordered(region, neighbour)] = separation(graph_.measure(region, neighbour));
    });
  }

  /// Opens the borders below a level whose regions have not changed since they were judged, then
  /// judges those that have.
  bool openOnce(double level) {
    std::vector<std::pair<double, Pair>> open;
    for (const auto& [pair, value] : separation_) {
      if (value < level) open.emplace_back(value, pair);
    }
    std::sort(open.begin(), open.end());
    std::vector<std::uint32_t> changed;
    std::vector<bool> has_changed(graph_.size(), false);
    for (const auto& [value, pair] : open) {
      if (has_changed[pair.first] || has_changed[pair.second]) continue;
      has_changed[pair.first] = has_changed[pair.second] = true;
      changed.push_back(merge(pair));
    }
    for (const std::uint32_t region : changed) judge(region);
    return !changed.empty();
  }

  std::uint32_t merge(const Pair& pair) {
    for (const std::uint32_t region : {pair.first, pair.second}) {
      graph_.forEachNeighbour(
          region, [&](std::uint32_t neighbour) { separation_.erase(ordered(region, neighbour)); });
    }
    const std::uint32_t keeper = graph_.merge(pair.first, pair.second);
    const std::uint32_t other = keeper == pair.first ? pair.second : pair.first;
    sets_.unite(keeper, other);
    is_alive_[other] = false;
    return keeper;
  }

  Pair leastParted(std::uint32_t region) const {
    Pair least;
    double lowest = std::numeric_limits<double>::infinity();
    graph_.forEachNeighbour(region, [&](std::uint32_t neighbour) {
      const Pair pair = ordered(region, neighbour);
      const double value = separation_.at(pair);
      if (value >= lowest) return;
      lowest = value;
      least = pair;
    });
    return least;
  }

  RegionGraph graph_;
  DisjointSets sets_;
  std::vector<bool> is_alive_;
  std::map<Pair, double> separation_;
};

}  // namespace

std::vector<std::uint32_t> mergeByBorders(RegionGraph graph, const AreaParams& params) {
  Merger merger(std::move(graph));
  for (const double level : kLevels) merger.openBordersBelow(level * params.min_separation);
  merger.joinWhere([&](const RegionShape& shape) {
    return shape.size < params.min_area_size || shape.clearance < params.min_area_clearance;
  });
  return merger.result();
}

}  // namespace agrid
