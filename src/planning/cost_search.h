// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planning/cost_field.h"
#include "planning/pixel_region.h"

namespace agrid::planning {

/// A* over the pixels of a costmap, from centre to centre by their sides and corners; a diagonal
/// step needs both pixels beside it (Hart, Nilsson and Raphael 1968).
class CostSearch {
 public:
  /// The cheapest way; what a step costs is its length times the mean of both pixels' factors.
  /// @param start  entered even if it is blocked
  /// @param region  pixels beyond it are not entered; null: all may be
  /// @return pixels from start to goal; empty if there is none, and then `reached` tells all that
  ///         the start is connected with
  std::vector<Pixel> find(const CostField& field, Pixel start, Pixel goal,
                          const PixelRegion* region);

  /// Reaches all that a pixel is connected with by the pixels' sides, which is all that `find` can
  /// reach, in a fraction of its time.
  void flood(const CostField& field, Pixel start);

  /// Whether the last search or flood has been there.
  bool reached(std::size_t pixel_index) const {
    return pixel_index < seen_.size() && seen_[pixel_index] == run_;
  }

 private:
  using Entry = std::pair<float, std::uint32_t>;  // least that a way through the pixel costs

  void prepare(std::size_t pixels);
  void reach(std::uint32_t pixel, float cost, std::uint8_t direction, float estimate);
  void expand(const CostField& field, std::uint32_t pixel, Pixel goal, const PixelRegion* region);
  std::vector<Pixel> wayTo(const MapGeometry& geometry, Pixel start, Pixel goal) const;

  std::vector<float> costs_;
  std::vector<std::uint8_t> directions_;  ///< by which each pixel was entered
  std::vector<std::uint32_t> seen_;       ///< in which run
  std::vector<Entry> queue_;
  std::uint32_t run_ = 0;
};

}  // namespace agrid::planning
