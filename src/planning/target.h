// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "planning/portal_graph.h"
#include "planning/region_labels.h"

namespace agrid::planning {

/// A region of which an area has some pixels, and others have the rest.
struct TargetPart {
  std::uint32_t region = kNoNode;
  std::shared_ptr<const RegionParts> parts;
};

/// Where a path ends: at one point, or at any pixel of an area.
struct Target {
  std::optional<FinePoint> point;
  std::uint16_t label = 0;             ///< without a point: of the area
  PixelBox box;                        ///< of the target's pixels
  std::vector<std::uint32_t> regions;  ///< of the point, or that lie in the area; sorted
  std::vector<TargetPart> parts = {};  ///< without a point: other regions of the area; sorted

  /// No way from there to the target is shorter [px].
  double distanceFrom(FinePoint p) const;
};

}  // namespace agrid::planning
