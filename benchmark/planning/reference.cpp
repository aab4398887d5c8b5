// SPDX-License-Identifier: BSD-3-Clause
#include "planning/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace agrid::bench {
namespace {

constexpr int kMaxMoves = 200;

}  // namespace

Reference::Reference(const Ground& ground, PixelAStar& a_star)
    : ground_(ground),
      a_star_(a_star),
      costs_(ground.free.size()),
      parents_(ground.free.size()),
      stamps_(ground.free.size(), 0) {}

Point2 Reference::center(std::size_t pixel) const {
  const auto w = static_cast<std::size_t>(ground_.width);
  return {static_cast<double>(pixel % w), static_cast<double>(pixel / w)};
}

double Reference::distance(std::size_t a, std::size_t b) const {
  return (center(a) - center(b)).norm();
}

/// From pixel centre to pixel centre; through a corner only where both pixels beside it are free.
bool Reference::sees(std::size_t a, std::size_t b) const {
  const auto w = static_cast<std::int64_t>(ground_.width);
  const std::int64_t across = static_cast<std::int64_t>(b) % w - static_cast<std::int64_t>(a) % w;
  const std::int64_t down = static_cast<std::int64_t>(b) / w - static_cast<std::int64_t>(a) / w;
  const std::int64_t step_x = across < 0 ? -1 : 1;
  const std::int64_t step_y = down < 0 ? -w : w;
  const std::int64_t dx = std::abs(across);
  const std::int64_t dy = std::abs(down);
  const std::uint8_t* p = ground_.free.data() + a;
  std::int64_t ahead = dx - dy;  // above 0: the line leaves the pixel through its side in x
  for (std::int64_t left = dx + dy; left > 0; --left) {
    if (ahead > 0) {
      p += step_x;
      ahead -= 2 * dy;
    } else if (ahead < 0) {
      p += step_y;
      ahead += 2 * dx;
    } else {
      if (p[step_x] == 0 || p[step_y] == 0) return false;
      p += step_x + step_y;
      ahead += 2 * (dx - dy);
      --left;
    }
    if (*p == 0) return false;
  }
  return true;
}

void Reference::push(std::uint32_t pixel, float cost, std::uint32_t parent, std::size_t goal) {
  if (stamps_[pixel] == stamp_ + 1) return;
  if (stamps_[pixel] == stamp_ && costs_[pixel] <= cost) return;
  stamps_[pixel] = stamp_;
  costs_[pixel] = cost;
  parents_[pixel] = parent;
  heap_.push_back({cost + static_cast<float>(distance(pixel, goal)), cost, pixel});
  std::push_heap(heap_.begin(), heap_.end());
}

void Reference::settle(std::uint32_t pixel) {
  if (sees(parents_[pixel], pixel)) return;
  float best = std::numeric_limits<float>::max();
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const auto next = static_cast<std::uint32_t>(pixel + dx + dy * ground_.width);
      if (stamps_[next] != stamp_ + 1 || !sees(next, pixel)) continue;
      const float cost = costs_[next] + static_cast<float>(distance(next, pixel));
      if (cost >= best) continue;
      best = cost;
      parents_[pixel] = next;
    }
  }
  costs_[pixel] = best;
}

void Reference::expand(std::uint32_t pixel, std::size_t goal) {
  settle(pixel);
  stamps_[pixel] = static_cast<std::uint16_t>(stamp_ + 1);
  const std::uint32_t parent = parents_[pixel];
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const auto next = static_cast<std::uint32_t>(pixel + dx + dy * ground_.width);
      const auto side_x = static_cast<std::uint32_t>(pixel + dx);
      const auto side_y = static_cast<std::uint32_t>(pixel + dy * ground_.width);
      if (!ground_.free[next] || !ground_.free[side_x] || !ground_.free[side_y]) continue;
      push(next, costs_[parent] + static_cast<float>(distance(parent, next)), parent, goal);
    }
  }
}

std::vector<std::size_t> Reference::lazyThetaStar(std::size_t start, std::size_t goal) {
  stamp_ = static_cast<std::uint16_t>(stamp_ + 2);
  if (stamp_ == 0) {
    std::fill(stamps_.begin(), stamps_.end(), std::uint16_t{0});
    stamp_ = 2;
  }
  heap_.clear();
  push(static_cast<std::uint32_t>(start), 0, static_cast<std::uint32_t>(start), goal);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry best = heap_.back();
    heap_.pop_back();
    if (stamps_[best.pixel] != stamp_ || best.cost > costs_[best.pixel]) continue;
    expand(best.pixel, goal);
    if (best.pixel == goal) break;
  }
  std::vector<std::size_t> way;
  if (stamps_[goal] != stamp_ + 1) return way;
  for (std::size_t pixel = goal; pixel != start; pixel = parents_[pixel]) way.push_back(pixel);
  way.push_back(start);
  return way;
}

/// Leaves out every point that its neighbours on the way see past, forwards and backwards.
std::vector<std::size_t> Reference::pulled(const std::vector<std::size_t>& way) const {
  std::vector<std::size_t> corners = way;
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<std::size_t> kept{corners.front()};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      if (!sees(kept.back(), corners[i + 1])) kept.push_back(corners[i]);
    }
    kept.push_back(corners.back());
    std::reverse(kept.begin(), kept.end());
    corners = kept;
  }
  return corners;
}

/// Moves each corner to the neighbouring pixel that shortens the way most; false if none does.
bool Reference::moveCorners(std::vector<std::size_t>& corners) const {
  bool moved = false;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::size_t from = corners[i];
    double best = distance(corners[i - 1], from) + distance(from, corners[i + 1]) - 1e-9;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto to = static_cast<std::size_t>(static_cast<std::int64_t>(from) + dx +
                                                 std::int64_t{dy} * ground_.width);
        const double sum = distance(corners[i - 1], to) + distance(to, corners[i + 1]);
        if (sum >= best || !sees(corners[i - 1], to) || !sees(to, corners[i + 1])) continue;
        best = sum;
        corners[i] = to;
        moved = true;
      }
    }
  }
  return moved;
}

double Reference::pulledLength(const std::vector<std::size_t>& way) const {
  std::vector<std::size_t> corners = pulled(way);
  for (int i = 0; i < kMaxMoves && moveCorners(corners); ++i) corners = pulled(corners);
  double sum = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) sum += distance(corners[i - 1], corners[i]);
  return sum;
}

double Reference::length(std::size_t start, std::size_t goal) {
  if (start == goal) return 0;
  if (a_star_.search(start, goal) < 0) return -1;
  const double from_a_star = pulledLength(a_star_.way());
  return std::min(from_a_star, pulledLength(lazyThetaStar(start, goal)));
}

}  // namespace agrid::bench
