// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/ground.h"

namespace agrid::bench {

/// A* over the pixels as a careful programmer writes it: eight neighbours without cutting corners,
/// octile heuristic, flat arrays, a binary heap without decrease-key, and stamps instead of
/// clearing anything from one query to the next.
class PixelAStar {
 public:
  /// `ground` must outlive this.
  explicit PixelAStar(const Ground& ground);

  /// Length of the shortest way over pixel centres [px]; negative if there is none.
  double search(std::size_t start, std::size_t goal);
  /// Pixels of the last way found, goal first.
  std::vector<std::size_t> way() const;

 private:
  struct Entry {
    float bound;
    float cost;
    std::uint32_t pixel;

    /// The largest of a heap comes first: the smallest bound, then the one farthest on its way.
    bool operator<(const Entry& other) const {
      return bound > other.bound || (bound == other.bound && cost < other.cost);
    }
  };

  double heuristic(std::uint32_t pixel) const;
  void reach(std::uint32_t pixel, float cost, std::uint8_t direction);
  void expand(std::uint32_t pixel, float cost);

  const Ground& ground_;
  std::vector<float> costs_;
  std::vector<std::uint16_t> stamps_;
  std::vector<std::uint8_t> directions_;  ///< from which neighbour a pixel was reached
  std::vector<Entry> heap_;
  std::int64_t offsets_[8];
  std::uint16_t stamp_ = 0;
  int goal_x_ = 0;
  int goal_y_ = 0;
  std::size_t start_ = 0;
  std::size_t goal_ = 0;
};

}  // namespace agrid::bench
