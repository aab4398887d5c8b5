// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "agrid/geometry/point2.h"

namespace agrid {

/// Points in squares as wide as the reach of a search, so that a search sees nine squares.
class NearPoints {
 public:
  explicit NearPoints(double reach) : reach_(reach) {}

  void add(const Point2& point, std::size_t number) {
    squares_[key(row(point.x()), row(point.y()))].push_back(number);
  }
  /// Calls f(number) for each point within reach and for some beyond, in an order that depends on
  /// nothing but the points and the order they were added in.
  template <typename F>
  void forEachNear(const Point2& point, F f) const {
    for (std::int64_t y = row(point.y()) - 1; y <= row(point.y()) + 1; ++y) {
      for (std::int64_t x = row(point.x()) - 1; x <= row(point.x()) + 1; ++x) {
        const auto square = squares_.find(key(x, y));
        if (square == squares_.end()) continue;
        for (const std::size_t number : square->second) f(number);
      }
    }
  }

 private:
  std::int64_t row(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate / reach_));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32U ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
  }

  double reach_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> squares_;
};

}  // namespace agrid
