// SPDX-License-Identifier: BSD-3-Clause
#include "planning/forbidden_between.h"

#include <algorithm>
#include <deque>

namespace agrid::planning {
namespace {

constexpr std::uint32_t kFar = 0xffffffffU;

struct Step {
  std::uint32_t entered = kFar;  ///< forbidden pieces on the way to a node
  std::uint32_t before = kNoNode;
};

std::vector<std::uint16_t> labelsOnWay(const std::vector<Step>& steps, const PortalGraph& areas,
                                       std::uint32_t node) {
  std::vector<std::uint16_t> labels;
  for (; node != kNoNode; node = steps[node].before) {
    const std::uint32_t before = steps[node].before;
    if (before == kNoNode || steps[node].entered == steps[before].entered) continue;
    const auto label = static_cast<std::uint16_t>(areas.classOf(node));
    labels.erase(std::remove(labels.begin(), labels.end(), label), labels.end());
    labels.push_back(label);
  }
  std::reverse(labels.begin(), labels.end());
  return labels;
}

}  // namespace

std::vector<std::uint16_t> forbiddenBetween(const PortalGraph& areas, std::uint32_t start,
                                            const std::function<bool(std::uint32_t)>& isGoal,
                                            const std::function<bool(std::uint16_t)>& isForbidden) {
  std::vector<Step> steps(areas.nodeCount());
  std::vector<bool> done(steps.size());
  std::deque<std::uint32_t> open{start};
  steps[start].entered = 0;
  while (!open.empty()) {
    const std::uint32_t here = open.front();
    open.pop_front();
    if (done[here]) continue;
    done[here] = true;
    if (isGoal(here)) return labelsOnWay(steps, areas, here);
    for (const std::uint32_t portal : areas.portalsOf(here)) {
      const std::uint32_t next = areas.portals()[portal].other(here);
      const bool costs = isForbidden(static_cast<std::uint16_t>(areas.classOf(next)));
      const std::uint32_t entered = steps[here].entered + (costs ? 1 : 0);
      if (entered >= steps[next].entered) continue;
      steps[next] = {entered, here};
      if (costs) {
        open.push_back(next);
      } else {
        open.push_front(next);
      }
    }
  }
  return {};
}

}  // namespace agrid::planning
