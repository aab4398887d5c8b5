// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_search.h"

#include <algorithm>
#include <functional>

namespace agrid::planning {
namespace {

constexpr std::uint32_t kNoState = 0xffffffff;

/// A state is numbered by its portal and the side that it is crossed to.
std::uint32_t stateOf(std::uint32_t portal, std::size_t side) {
  return 2 * portal + static_cast<std::uint32_t>(side);
}

/// What an entry of the open list stands for: a portal reached, or a leg from the start or to the
/// goal. A leg is first taken for straight, then for as long as is hoped, then measured.
enum Kind : std::uint32_t {
  kReached,
  kStraightFirstLeg,
  kHopedFirstLeg,
  kStraightLastLeg,
  kHopedLastLeg,
  kKinds
};

}  // namespace

struct PortalSearch::State {
  float cost = 0;
  float rest = 0;  ///< no way from here to the goal is shorter
  std::uint32_t parent = kNoState;
  std::uint32_t search = 0;  ///< in which the above was written
};

/// Kept from search to search, since clearing it would take longer than most searches.
struct PortalSearch::Memory {
  std::vector<State> states;
  std::vector<std::pair<float, std::uint32_t>> open;
  std::uint32_t search = 0;

  void begin(std::size_t state_count) {
    open.clear();
    if (states.size() >= state_count && ++search != 0) return;
    states.assign(std::max(states.size(), state_count), State{});
    search = 1;
  }
};

PortalSearch::Memory& PortalSearch::threadMemory() {
  thread_local Memory memory;
  return memory;
}

PortalSearch::PortalSearch(const Roadmap& roadmap, Measure measure, const Landmarks& landmarks,
                           RoadGoal& goal)
    : roadmap_(roadmap),
      regions_(roadmap.regions()),
      measure_(measure),
      landmarks_(landmarks),
      goal_(goal),
      memory_(threadMemory()),
      last_(kNoState) {
  findGoalLengths();
}

/// Every way to the goal ends with a portal of its regions and a leg that is at least straight.
void PortalSearch::findGoalLengths() {
  goal_nearest_.fill(kUnreachable);
  goal_farthest_.fill(-kUnreachable);
  for (const std::uint32_t region : goal_.regions()) {
    for (const std::uint32_t portal : regions_.portalsOf(region)) {
      const auto side = static_cast<std::uint32_t>(regions_.portals()[portal].sideOf(region));
      const float leg = goal_.straightLeg(measure_, {portal, side});
      const Landmarks::Lengths& lengths = landmarks_.of(portal);
      for (std::size_t k = 0; k < Landmarks::kCount; ++k) {
        goal_nearest_[k] = std::min(goal_nearest_[k], lengths.to[k] - lengths.slack + leg);
        goal_farthest_[k] = std::max(goal_farthest_[k], lengths.to[k] + lengths.slack - leg);
      }
    }
  }
}

/// No way from a portal to the goal is shorter: by the triangle inequality, with each landmark.
float PortalSearch::restOf(std::uint32_t portal) const {
  const Portal& place = regions_.portals()[portal];
  auto rest = static_cast<float>(goal_.target().distanceFrom(place.crossing()) - place.reach);
  const Landmarks::Lengths& lengths = landmarks_.of(portal);
  for (std::size_t k = 0; k < Landmarks::kCount; ++k) {
    rest = std::max({rest, goal_nearest_[k] - lengths.to[k] - lengths.slack,
                     lengths.to[k] - goal_farthest_[k] - lengths.slack});
  }
  return rest;
}

float PortalSearch::find(RoadEnd& start, float limit, const StopCheck& stop) {
  best_ = limit;
  last_ = kNoState;
  end_ = nullptr;
  memory_.begin(2 * regions_.portals().size());
  begin(start);
  auto& open = memory_.open;
  for (std::size_t i = 0; !open.empty() && open.front().first < best_; ++i) {
    if (i % 256 == 0) stop.check();
    const auto [estimate, entry] = open.front();
    std::pop_heap(open.begin(), open.end(), std::greater<>());
    open.pop_back();
    const std::uint32_t state = entry / kKinds;
    const std::uint32_t kind = entry % kKinds;
    if (kind == kStraightFirstLeg || kind == kHopedFirstLeg) {
      takeFirstLeg(start, state, kind);
    } else if (kind != kReached) {
      takeLastLeg(state, kind);
    } else if (!(estimate > memory_.states[state].cost + memory_.states[state].rest)) {
      expand(state);
    }
  }
  return best_;
}

std::vector<Crossing> PortalSearch::way() const {
  std::vector<Crossing> way;
  for (std::uint32_t s = last_; s != kNoState; s = memory_.states[s].parent) {
    way.push_back({s / 2, s % 2});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

void PortalSearch::push(float estimate, std::uint32_t state, std::uint32_t kind) {
  if (!(estimate < best_)) return;
  memory_.open.emplace_back(estimate, kKinds * state + kind);
  std::push_heap(memory_.open.begin(), memory_.open.end(), std::greater<>());
}

void PortalSearch::begin(RoadEnd& start) {
  std::size_t rank = 0;
  for (const std::uint32_t portal : regions_.portalsOf(start.region())) {
    const std::size_t beyond = 1 - regions_.portals()[portal].sideOf(start.region());
    const float leg = start.straightLength(measure_, rank++);
    push(leg + restOf(portal), stateOf(portal, beyond), kStraightFirstLeg);
  }
}

void PortalSearch::takeFirstLeg(RoadEnd& start, std::uint32_t state, std::uint32_t kind) {
  const std::size_t rank = roadmap_.rankOf(state / 2, 1 - state % 2);
  if (kind == kStraightFirstLeg) {
    push(start.hopedLength(measure_, rank) + restOf(state / 2), state, kHopedFirstLeg);
  } else {
    reach(state, kNoState, start.length(measure_, rank));
  }
}

void PortalSearch::takeLastLeg(std::uint32_t state, std::uint32_t kind) {
  const float cost = memory_.states[state].cost;
  const Crossing crossing{state / 2, state % 2};
  if (kind == kStraightLastLeg) {
    push(cost + goal_.hopedLeg(measure_, crossing), state, kHopedLastLeg);
    return;
  }
  const RoadGoal::Leg leg = goal_.leg(measure_, crossing);
  if (!(cost + leg.length < best_)) return;
  best_ = cost + leg.length;
  last_ = state;
  end_ = leg.end;
}

void PortalSearch::reach(std::uint32_t state, std::uint32_t parent, float cost) {
  State& known = memory_.states[state];
  if (known.search != memory_.search) {
    known = {kUnreachable, restOf(state / 2), kNoState, memory_.search};
  }
  if (!(cost < known.cost)) return;
  known.cost = cost;
  known.parent = parent;
  push(cost + known.rest, state, kReached);
}

void PortalSearch::expand(std::uint32_t state) {
  const float cost = memory_.states[state].cost;
  const std::uint32_t portal = state / 2;
  const std::size_t side = state % 2;
  const std::uint32_t region = regions_.portals()[portal].nodes[side];
  if (goal_.endsIn(region)) {
    push(cost + goal_.straightLeg(measure_, {portal, state % 2}), state, kStraightLastLeg);
  }
  roadmap_.forEachOnwards(measure_, portal, side, [&](std::uint32_t other, float length) {
    const std::size_t beyond = 1 - regions_.portals()[other].sideOf(region);
    reach(stateOf(other, beyond), state, cost + length);
  });
}

}  // namespace agrid::planning
