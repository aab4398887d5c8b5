// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/roadmap.h"

namespace agrid::planning {

/// Lengths of the ways between portals and a few landmarks, by one measure:
/// the difference of two portals' lengths bounds the way between them from below (ALT: Goldberg and
/// Harrelson 2005). Each component has landmarks of its own, portals far from each other.
class Landmarks {
 public:
  static constexpr std::size_t kCount = 16;
  using Lengths = std::array<float, kCount>;

  /// @throws Stopped
  Landmarks(const Roadmap& roadmap, Measure measure, const StopCheck& stop);

  const Lengths& of(std::uint32_t portal) const { return lengths_[portal]; }

 private:
  std::vector<Lengths> lengths_;  ///< of the portals
};

}  // namespace agrid::planning
