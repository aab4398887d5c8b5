// SPDX-License-Identifier: BSD-3-Clause
#include "planning/barriers.h"

#include <algorithm>
#include <queue>

#include "planning/door_surroundings.h"
#include "planning/radius_level.h"

namespace agrid::planning {
namespace {

constexpr std::size_t kNoBarrier = static_cast<std::size_t>(-1);

}  // namespace

BarrierGraph::BarrierGraph(const SemanticMap& map, const RadiusLevel& level,
                           const Obstacles& obstacles) {
  const DoorSurroundings surroundings(map.area_map.doors, level, obstacles);
  for (std::size_t door = 0; door < map.area_map.doors.size(); ++door) {
    const auto joined = surroundings.joinedWhenOpen(door);
    for (const auto& components : joined) add({door, false}, components);
    if (joined.empty()) add({door, true}, surroundings.joinedWhenWider(door));
  }
}

void BarrierGraph::add(const Barrier& barrier, const std::vector<std::uint32_t>& components) {
  if (components.size() < 2) return;
  for (const std::uint32_t component : components) {
    barriers_of_[component].push_back(barriers_.size());
  }
  barriers_.push_back(barrier);
  beside_.push_back(components);
}

std::vector<Barrier> BarrierGraph::fewestBetween(std::uint32_t start,
                                                 const std::vector<std::uint32_t>& goals) const {
  struct Step {
    std::size_t barrier;
    std::uint32_t from;
  };
  std::map<std::uint32_t, Step> came_by{{start, {kNoBarrier, start}}};
  std::queue<std::uint32_t> open;
  open.push(start);
  for (; !open.empty(); open.pop()) {
    std::uint32_t here = open.front();
    if (std::find(goals.begin(), goals.end(), here) != goals.end()) {
      std::vector<Barrier> way;
      for (; here != start; here = came_by.at(here).from) {
        way.push_back(barriers_[came_by.at(here).barrier]);
      }
      std::reverse(way.begin(), way.end());
      return way;
    }
    const auto found = barriers_of_.find(here);
    if (found == barriers_of_.end()) continue;
    for (const std::size_t barrier : found->second) {
      for (const std::uint32_t to : beside_[barrier]) {
        if (came_by.emplace(to, Step{barrier, here}).second) open.push(to);
      }
    }
  }
  return {};
}

const BarrierGraph& Barriers::of(const SemanticMap& map, const RadiusLevel& level,
                                 const Obstacles& obstacles) const {
  std::call_once(made_,
                 [&] { graph_ = std::make_unique<const BarrierGraph>(map, level, obstacles); });
  return *graph_;
}

}  // namespace agrid::planning
