// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "agrid/areas/area_map.h"

namespace agrid {

/// How the areas that people drew lie on those that were found. Both are counted from 1; 0: none.
class GivenOverlap {
 public:
  /// @param given  labels of the same pixels as the areas'
  GivenOverlap(const std::vector<std::uint16_t>& given, const AreaMap& found);

  std::int64_t givenSize(std::uint16_t given) const { return given_sizes_[given]; }
  std::int64_t common(std::uint16_t given, std::uint16_t found) const;
  /// The given area that has the most of a found one, if it has half of it; else 0.
  std::uint16_t mainOf(std::uint16_t found) const;
  /// The found area that has the most of a given one; 0 if none has any.
  std::uint16_t bestFor(std::uint16_t given) const;
  /// Intersection over union, over pixels.
  double iou(std::uint16_t given, std::uint16_t found) const;
  /// Mean over the given areas that have pixels of the IoU with the best found one; 1 if none has.
  double meanIou() const;

 private:
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::int64_t> common_;  ///< by found, given
  std::vector<std::int64_t> given_sizes_;
  std::vector<std::int64_t> found_sizes_;
};

}  // namespace agrid
