// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/portal.h"

namespace agrid::planning {

/// Whether portals are maximal runs, or parts of them: sixteen of a run, if each is then 3 to 12
/// pixels long and wide.
enum class PortalCut { kWholeRuns, kParts };

/// A pair of neighbouring pixels in two nodes: side by side, or one above the other.
struct PixelPair {
  Pixel low;
  Pixel high;
  std::uint32_t a;
  std::uint32_t b;
};

/// Collects pairs, and which of the same two nodes lie next to each other, row by row.
class PortalRuns {
 public:
  /// @param width  of the columns from `first_x` on, in which the pairs' lower pixels lie
  explicit PortalRuns(std::size_t width, int first_x = 0)
      : first_x_(first_x), rows_{std::vector<Slot>(width + 2), std::vector<Slot>(width + 2)} {}

  void nextRow() {
    std::swap(rows_[0], rows_[1]);
    std::fill(rows_[1].begin(), rows_[1].end(), Slot{});
  }
  /// @param upwards  whether b lies above a, else beside it
  void add(Pixel p, bool upwards, std::uint32_t a, std::uint32_t b) {
    const auto added = static_cast<std::uint32_t>(pairs_.size());
    const auto x = static_cast<std::size_t>(p.x - first_x_) + 1;
    for (const Slot* slot :
         {&rows_[0][x - 1], &rows_[0][x], &rows_[0][x + 1], &rows_[1][x - 1], &rows_[1][x]}) {
      for (const std::uint32_t pair : slot->pairs) {
        if (pair != kNoNode && sameNodes(pairs_[pair], a, b)) links_.push_back({pair, added});
      }
    }
    rows_[1][x].pairs[upwards ? 1 : 0] = added;
    pairs_.push_back({p, upwards ? Pixel{p.x, p.y + 1} : Pixel{p.x + 1, p.y}, a, b});
  }
  std::vector<Portal> portals(PortalCut cut) const;

 private:
  struct Slot {
    std::array<std::uint32_t, 2> pairs{kNoNode, kNoNode};
  };
  static bool sameNodes(const PixelPair& pair, std::uint32_t a, std::uint32_t b) {
    return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
  }
  int first_x_;
  std::array<std::vector<Slot>, 2> rows_;
  std::vector<PixelPair> pairs_;
  std::vector<std::array<std::uint32_t, 2>> links_;
};

}  // namespace agrid::planning
