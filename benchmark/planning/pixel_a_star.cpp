// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pixel_a_star.h"

#include <algorithm>
#include <cmath>

namespace agrid::bench {
namespace {

constexpr float kDiagonal = 1.41421356F;

}  // namespace

PixelAStar::PixelAStar(const Ground& ground)
    : ground_(ground),
      costs_(ground.free.size()),
      stamps_(ground.free.size(), 0),
      directions_(ground.free.size()) {
  // four sides, then four corners; corner 4 + i lies between the sides i and (i + 1) % 4
  const std::int64_t w = ground.width;
  const std::int64_t offsets[8] = {1, w, -1, -w, 1 + w, w - 1, -1 - w, 1 - w};
  std::copy(offsets, offsets + 8, offsets_);
}

double PixelAStar::heuristic(std::uint32_t pixel) const {
  const auto w = static_cast<std::uint32_t>(ground_.width);
  const int dx = std::abs(static_cast<int>(pixel % w) - goal_x_);
  const int dy = std::abs(static_cast<int>(pixel / w) - goal_y_);
  return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
}

void PixelAStar::reach(std::uint32_t pixel, float cost, std::uint8_t direction) {
  if (stamps_[pixel] == stamp_ && costs_[pixel] <= cost) return;
  stamps_[pixel] = stamp_;
  costs_[pixel] = cost;
  directions_[pixel] = direction;
  heap_.push_back({static_cast<float>(cost + heuristic(pixel)), cost, pixel});
  std::push_heap(heap_.begin(), heap_.end());
}

void PixelAStar::expand(std::uint32_t pixel, float cost) {
  // the outermost ring is never free, so that every neighbour exists
  bool side_free[4];
  for (int i = 0; i < 4; ++i) {
    const auto next = static_cast<std::uint32_t>(pixel + offsets_[i]);
    side_free[i] = ground_.free[next] != 0;
    if (side_free[i]) reach(next, cost + 1, static_cast<std::uint8_t>(i));
  }
  for (int i = 0; i < 4; ++i) {
    if (!side_free[i] || !side_free[(i + 1) % 4]) continue;
    const auto next = static_cast<std::uint32_t>(pixel + offsets_[4 + i]);
    if (ground_.free[next] != 0) reach(next, cost + kDiagonal, static_cast<std::uint8_t>(4 + i));
  }
}

double PixelAStar::search(std::size_t start, std::size_t goal) {
  if (++stamp_ == 0) {
    std::fill(stamps_.begin(), stamps_.end(), std::uint16_t{0});
    stamp_ = 1;
  }
  start_ = start;
  goal_ = goal;
  goal_x_ = static_cast<int>(goal % static_cast<std::size_t>(ground_.width));
  goal_y_ = static_cast<int>(goal / static_cast<std::size_t>(ground_.width));
  heap_.clear();
  reach(static_cast<std::uint32_t>(start), 0, 0);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry best = heap_.back();
    heap_.pop_back();
    if (best.pixel == goal) return static_cast<double>(best.cost);
    if (best.cost <= costs_[best.pixel]) expand(best.pixel, best.cost);
  }
  return -1;
}

std::vector<std::size_t> PixelAStar::way() const {
  std::vector<std::size_t> pixels{goal_};
  while (pixels.back() != start_) {
    const std::int64_t back = offsets_[directions_[pixels.back()]];
    pixels.push_back(static_cast<std::size_t>(static_cast<std::int64_t>(pixels.back()) - back));
  }
  return pixels;
}

}  // namespace agrid::bench
