// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planning/region_roads.h"

namespace agrid::planning {

/// A region of other free space that holds all pixels of the one whose roads are to be made.
struct FormerRegion {
  const RegionRoads* roads = nullptr;
  std::uint32_t region = kNoNode;
  std::vector<const Portal*> portals;
  std::vector<PixelBox> changed;  ///< free space is the same outside
};

/// What was seen of what in a former region, where nothing changed in between.
class KnownSights {
 public:
  KnownSights() = default;
  /// The arguments must outlive the object.
  KnownSights(const FormerRegion& former, std::uint32_t region,
              const std::vector<TurningPoint>& points, const std::vector<const Portal*>& portals);

  /// Whether two turning points see each other, both of them tangent.
  std::optional<bool> edge(std::size_t a, std::size_t b) const;
  /// Of a turning point or portal, by its node's number, from a portal.
  std::optional<Sights> from(std::size_t portal, std::size_t node) const;

 private:
  using Node = RegionRoads::Node;
  static constexpr Node kUnknown = 0xffff;
  bool isUnchangedBetween(FinePoint a, FinePoint b) const;

  const FormerRegion* former_ = nullptr;
  std::vector<Node> former_node_;  ///< of the points, then of the portals
  std::vector<FinePoint> places_;  ///< of the same
  std::size_t point_count_ = 0;
  std::vector<bool> edges_;  ///< of each two former turning points
};

}  // namespace agrid::planning
