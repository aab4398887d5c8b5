// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/ground.h"
#include "planning/pixel_a_star.h"

namespace agrid::bench {

/// Short collision-free paths with corners at pixel centres, where nobody has searched for the best
/// ones: the shorter of Lazy Theta* (Nash et al. 2010) and a pixel A*, both pulled like a string.
/// Near the best, not the best: a good planner's paths may be shorter.
class Reference {
 public:
  /// `ground` and `a_star` must outlive this.
  Reference(const Ground& ground, PixelAStar& a_star);

  /// Length in pixels; negative if there is no path.
  double length(std::size_t start, std::size_t goal);

 private:
  struct Entry {
    float bound;
    float cost;
    std::uint32_t pixel;

    bool operator<(const Entry& other) const {
      return bound > other.bound || (bound == other.bound && cost < other.cost);
    }
  };

  Point2 center(std::size_t pixel) const;
  double distance(std::size_t a, std::size_t b) const;
  bool sees(std::size_t a, std::size_t b) const;
  void push(std::uint32_t pixel, float cost, std::uint32_t parent, std::size_t goal);
  /// The parent was taken in hope; now that the pixel is wanted, it must be seen.
  void settle(std::uint32_t pixel);
  void expand(std::uint32_t pixel, std::size_t goal);
  std::vector<std::size_t> lazyThetaStar(std::size_t start, std::size_t goal);
  std::vector<std::size_t> pulled(const std::vector<std::size_t>& way) const;
  bool moveCorners(std::vector<std::size_t>& corners) const;
  double pulledLength(const std::vector<std::size_t>& way) const;

  const Ground& ground_;
  PixelAStar& a_star_;
  std::vector<float> costs_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint16_t> stamps_;  ///< 2 * query: reached, 2 * query + 1: expanded
  std::vector<Entry> heap_;
  std::uint16_t stamp_ = 0;
};

}  // namespace agrid::bench
