// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cost_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace agrid::planning {
namespace {

struct Step {
  int x;
  int y;
  float length;
};

constexpr float kDiagonal = 1.41421356F;
constexpr std::array<Step, 8> kSteps = {{{1, 0, 1},
                                         {0, 1, 1},
                                         {-1, 0, 1},
                                         {0, -1, 1},
                                         {1, 1, kDiagonal},
                                         {-1, 1, kDiagonal},
                                         {-1, -1, kDiagonal},
                                         {1, -1, kDiagonal}}};

/// Nothing is shorter where every pixel counts 1.
float leastCost(Pixel a, Pixel b) {
  const int dx = std::abs(a.x - b.x);
  const int dy = std::abs(a.y - b.y);
  return static_cast<float>(std::max(dx, dy) - std::min(dx, dy)) +
         kDiagonal * static_cast<float>(std::min(dx, dy));
}

}  // namespace

void CostSearch::prepare(std::size_t pixels) {
  queue_.clear();
  if (pixels != seen_.size() || run_ == std::numeric_limits<std::uint32_t>::max()) {
    costs_.assign(pixels, 0);
    directions_.assign(pixels, 0);
    seen_.assign(pixels, 0);
    run_ = 0;
  }
  ++run_;
}

void CostSearch::reach(std::uint32_t pixel, float cost, std::uint8_t direction, float estimate) {
  if (seen_[pixel] == run_ && costs_[pixel] <= cost) return;
  seen_[pixel] = run_;
  costs_[pixel] = cost;
  directions_[pixel] = direction;
  queue_.emplace_back(estimate, pixel);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

void CostSearch::expand(const CostField& field, std::uint32_t pixel, Pixel goal,
                        const PixelRegion* region) {
  const MapGeometry& geometry = field.geometry();
  const Pixel at = geometry.pixel(pixel);
  const auto isOpen = [&](Pixel p) {
    return geometry.contains(p) && !field.isBlocked(geometry.index(p));
  };
  const float here = field.factor(pixel);
  for (std::uint8_t i = 0; i < kSteps.size(); ++i) {
    const Step& step = kSteps[i];
    const Pixel next{at.x + step.x, at.y + step.y};
    if (!isOpen(next)) continue;
    if (i >= 4 && (!isOpen({at.x + step.x, at.y}) || !isOpen({at.x, at.y + step.y}))) continue;
    const std::size_t index = geometry.index(next);
    if (region != nullptr && !region->contains(index)) continue;
    const float cost = costs_[pixel] + step.length * (here + field.factor(index)) / 2;
    reach(static_cast<std::uint32_t>(index), cost, i, cost + leastCost(next, goal));
  }
}

std::vector<Pixel> CostSearch::wayTo(const MapGeometry& geometry, Pixel start, Pixel goal) const {
  std::vector<Pixel> way{goal};
  while (way.back() != start) {
    const Step& step = kSteps[directions_[geometry.index(way.back())]];
    way.push_back({way.back().x - step.x, way.back().y - step.y});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<Pixel> CostSearch::find(const CostField& field, Pixel start, Pixel goal,
                                    const PixelRegion* region) {
  const MapGeometry& geometry = field.geometry();
  prepare(geometry.pixelCount());
  reach(static_cast<std::uint32_t>(geometry.index(start)), 0, 0, leastCost(start, goal));
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [estimate, pixel] = queue_.back();
    queue_.pop_back();
    const Pixel at = geometry.pixel(pixel);
    if (at == goal) return wayTo(geometry, start, goal);
    if (estimate > costs_[pixel] + leastCost(at, goal)) continue;  // a cheaper way came later
    expand(field, pixel, goal, region);
  }
  return {};
}

void CostSearch::flood(const CostField& field, Pixel start) {
  const MapGeometry& geometry = field.geometry();
  prepare(geometry.pixelCount());
  std::vector<Pixel> open{start};
  seen_[geometry.index(start)] = run_;
  while (!open.empty()) {
    const Pixel at = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < 4; ++i) {  // the steps over sides come first
      const Pixel next{at.x + kSteps[i].x, at.y + kSteps[i].y};
      if (!geometry.contains(next)) continue;
      const std::size_t index = geometry.index(next);
      if (seen_[index] == run_ || field.isBlocked(index)) continue;
      seen_[index] = run_;
      open.push_back(next);
    }
  }
}

}  // namespace agrid::planning
