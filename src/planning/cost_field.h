// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "agrid/planning/costmap.h"

namespace agrid::planning {

/// What a pixel's length counts in each pixel of a costmap, at least 1.
class CostField {
 public:
  /// @param costmap  must outlive the object
  /// @param entered  counts 1 whatever its cost is: the robot is there
  CostField(const Costmap& costmap, const CostRules& rules, Pixel entered)
      : costmap_(costmap), entered_(costmap.geometry.index(entered)) {
    const auto factor = [&](int cost) {
      return static_cast<float>(1 + cost * rules.cost_factor / rules.neutral_cost);
    };
    for (int cost = 0; cost < 255; ++cost) {
      factors_.at(static_cast<std::size_t>(cost)) =
          cost < rules.lethal_cost ? factor(cost) : std::numeric_limits<float>::infinity();
    }
    factors_[kNoInformation] =
        rules.allow_unknown ? factor(kInscribed - 1) : std::numeric_limits<float>::infinity();
  }

  const MapGeometry& geometry() const { return costmap_.geometry; }
  /// Infinite where it may not be entered.
  float factor(std::size_t pixel_index) const {
    return pixel_index == entered_ ? 1 : factors_[costmap_.costs[pixel_index]];
  }
  bool isBlocked(std::size_t pixel_index) const {
    return factor(pixel_index) == std::numeric_limits<float>::infinity();
  }

 private:
  const Costmap& costmap_;
  std::size_t entered_;
  std::array<float, 256> factors_{};
};

}  // namespace agrid::planning
