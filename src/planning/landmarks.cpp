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

/// @param reach  of the portal: its own middle is another one
Landmarks::Lengths between(const Landmarks::Lengths& least, const Landmarks::Lengths& greatest,
                           float reach) {
  Landmarks::Lengths lengths;
  for (std::size_t k = 0; k < Landmarks::kCount; ++k) {
    lengths.to[k] = (least.to[k] + greatest.to[k]) / 2;
    lengths.slack = std::max(lengths.slack, greatest.to[k] - lengths.to[k] + reach);
  }
  return lengths;
}

}  // namespace

Landmarks::Landmarks(const Roadmap& roadmap, Measure measure, const StopCheck& stop) {
  std::vector<Lengths> lengths(roadmap.regions().portals().size());
  std::vector<float> reached(lengths.size(), kUnreachable);
  std::vector<bool> known(lengths.size());
  for (std::uint32_t first = 0; first < lengths.size(); ++first) {
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
        lengths[component[i]].to[k] = reached[component[i]];
        nearest[i] = std::min(nearest[i], reached[component[i]]);
        if (nearest[i] > nearest[farthest]) farthest = i;
      }
      landmark = component[farthest];
    }
    for (const std::uint32_t portal : component) known[portal] = true;
  }
  lengths_ = PagedArray<Lengths, 4>(std::move(lengths));
}

/// A new portal's border is made of borders of the base's portals.
Landmarks::Landmarks(const Landmarks& former, const Landmarks& base, const Roadmap& base_roadmap,
                     const FreeSpace& free, const Roadmap& roadmap)
    : lengths_(former.lengths_) {
  const PortalGraph& regions = base_roadmap.regions();
  while (lengths_.size() < roadmap.regions().portals().size()) lengths_.push_back({});
  for (const std::uint32_t number : roadmap.newPortals()) {
    if (number < base.lengths_.size()) {
      lengths_.edit(number) = base.of(number);
      continue;
    }
    const Portal& portal = roadmap.regions().portals()[number];
    const std::uint32_t low = regions.nodeAt(free.geometry().index(portal.middle));
    const std::uint32_t high = regions.nodeAt(free.geometry().index(portal.beyond));
    Lengths least;
    Lengths greatest;
    least.to.fill(kUnreachable);
    greatest.to.fill(-kUnreachable);
    for (const std::uint32_t other : regions.portalsOf(low)) {
      const Portal& place = regions.portals()[other];
      if (place.other(low) != high || !overlap(place.border, portal.border)) continue;
      for (std::size_t k = 0; k < kCount; ++k) {
        least.to[k] = std::min(least.to[k], base.of(other).to[k]);
        greatest.to[k] = std::max(greatest.to[k], base.of(other).to[k]);
      }
    }
    lengths_.edit(number) = between(least, greatest, static_cast<float>(portal.reach));
  }
}

}  // namespace agrid::planning
