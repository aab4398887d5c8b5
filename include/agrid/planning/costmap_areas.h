// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/geometry/segment.h"
#include "agrid/planning/costmap.h"

namespace agrid {

/// An area as a costmap shows it.
struct AreaCost {
  Polygon outline;    ///< in the costmap's frame [m]
  double size = 0;    ///< [m^2]
  double factor = 1;  ///< what a metre in it counts (areaCost); infinite: forbidden
};

bool operator==(const AreaCost& a, const AreaCost& b);

/// What tags say about where to drive, in the costmap's frame.
struct AreaCosts {
  std::vector<AreaCost> areas;
  std::vector<Segment> closed_doors;  ///< from jamb to jamb [m]
};

bool operator==(const AreaCosts& a, const AreaCosts& b);

/// The same, so that a robot can leave where it is: forbidden areas that hold it cost as much as an
/// area can without being forbidden, and closed doors within its radius are left out.
/// @param robot  in the costmap's frame [m]
AreaCosts leavable(AreaCosts areas, const Point2& robot, double robot_radius);

/// The costs of areas, by pixel of a costmap.
class CostmapAreas {
 public:
  /// The greatest cost of an area that is not forbidden: global_planner enters no pixel from 252
  /// on.
  static constexpr std::uint8_t kDearest = 250;

  /// Of areas that lie in one another the smaller one counts.
  /// @param rules  of the planner: the cost of a pixel makes it count the factor there
  CostmapAreas(const AreaCosts& areas, const MapGeometry& geometry, const CostRules& rules);

  /// Raises the costs of a costmap of the same geometry, row-major: forbidden areas and closed
  /// doors become lethal, dear ones cost more where something is known; nothing becomes cheaper.
  /// @param low, high  pixels from `low` to before `high` are touched, no others
  void raise(std::uint8_t* costs, Pixel low, Pixel high) const;
  /// All of it.
  void raise(Costmap& costmap) const;

  const MapGeometry& geometry() const { return geometry_; }

 private:
  MapGeometry geometry_;
  std::vector<std::uint8_t> costs_;  ///< by pixel; empty: no area costs anything
  std::vector<Segment> doors_;
};

/// The costs of areas as they are now: made anew only where something has changed.
class CurrentAreas {
 public:
  explicit CurrentAreas(const CostRules& rules) : rules_(rules) {}
  const CostmapAreas& get(const AreaCosts& areas, const MapGeometry& geometry);

 private:
  CostRules rules_;
  AreaCosts areas_;
  std::optional<CostmapAreas> made_;
};

}  // namespace agrid
