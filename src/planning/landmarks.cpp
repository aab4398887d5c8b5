// SPDX-License-Identifier: BSD-3-Clause
#include "planning/landmarks.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace agrid::planning {
namespace {

/// Dijkstra over the portals from `source`; what isn't reached keeps its value.
/// @param reached  kUnreachable for all portals of the component
/// @return the portals reached, nearest first
std::vector<std::uint32_t> spread(const Roadmap& roadmap, Measure measure, std::uint32_t source,
                                  std::vector<float>& reached) {
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<std::uint32_t> order;
  reached[source] = 0;
  open.emplace(0.0F, source);
  while (!open.empty()) {
    const auto [length, portal] = open.top();
    open.pop();
    if (length > reached[portal]) continue;
    order.push_back(portal);
    for (const std::size_t side : {0U, 1U}) {
      const auto visit = [&, from = length](std::uint32_t other, float onwards) {
        if (!(from + onwards < reached[other])) return;
        reached[other] = from + onwards;
        open.emplace(reached[other], other);
      };
      roadmap.forEachOnwards(measure, portal, side, visit);
    }
  }
  return order;
}

}  // namespace

Landmarks::Landmarks(const Roadmap& roadmap, Measure measure, const StopCheck& stop)
    : lengths_(roadmap.regions().portals().size()) {
  std::vector<float> reached(lengths_.size(), kUnreachable);
  std::vector<bool> known(lengths_.size());
  for (std::uint32_t first = 0; first < lengths_.size(); ++first) {
    if (known[first]) continue;
    std::vector<std::uint32_t> component = spread(roadmap, measure, first, reached);
    std::vector<float> nearest(component.size(), kUnreachable);
    std::uint32_t landmark = component.back();
    for (std::size_t k = 0; k < kCount; ++k) {
      stop.check();
      for (const std::uint32_t portal : component) reached[portal] = kUnreachable;
      spread(roadmap, measure, landmark, reached);
      std::size_t farthest = 0;
      for (std::size_t i = 0; i < component.size(); ++i) {
        lengths_[component[i]][k] = reached[component[i]];
        nearest[i] = std::min(nearest[i], reached[component[i]]);
        if (nearest[i] > nearest[farthest]) farthest = i;
      }
      landmark = component[farthest];
    }
    for (const std::uint32_t portal : component) known[portal] = true;
  }
}

}  // namespace agrid::planning
