// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/tags/tag.h"

namespace agrid::tools {

/// What two outlines of the same frame have in common [m^2]: the lengths of both on parallel lines
/// 2 cm apart, or 400 lines if they are longer than that.
double commonSurface(const Polygon& a, const Polygon& b);

/// Two areas whose outlines overlap.
struct OutlineShare {
  std::size_t a = 0;
  std::size_t b = 0;
  double of_a = 0;  ///< share of a's surface that lies in b, [0, 1]
  double of_b = 0;  ///< share of b's surface that lies in a, [0, 1]

  /// What both have in common over what either has.
  double overUnion() const;
};

/// All pairs of overlapping outlines, by a, then b.
std::vector<OutlineShare> outlineShares(const std::vector<AreaTag>& a,
                                        const std::vector<AreaTag>& b);

}  // namespace agrid::tools
