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
  struct Lengths {
    std::array<float, kCount> to{};
    float slack = 0;  ///< the lengths are right within it
  };

  /// @throws Stopped
  Landmarks(const Roadmap& roadmap, Measure measure, const StopCheck& stop);
  /// For a roadmap that was patched: its ways are no shorter than those of `base_roadmap`, in which
  /// the landmarks were chosen.
  Landmarks(const Landmarks& former, const Landmarks& base, const Roadmap& base_roadmap,
            const FreeSpace& free, const Roadmap& roadmap);

  const Lengths& of(std::uint32_t portal) const { return lengths_[portal]; }

 private:
  PagedArray<Lengths, 4> lengths_;  ///< of the portals
};

}  // namespace agrid::planning
