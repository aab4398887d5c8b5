// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "agrid/geometry/pose2.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Where a narrow place is looked for.
struct NarrowPlaceQuery {
  Point2 near_map = Point2::Zero();
  std::optional<double> yaw;        ///< it leads in this direction or back, within 45 degrees [rad]
  double reach = 1;                 ///< how far from the point its middle may be [m]
  double max_width = 2.6;           ///< [m]
  double max_clutter_diagonal = 1;  ///< as AreaParams::max_clutter_diagonal [m]
};

/// A place where two walls face each other.
struct NarrowPlace {
  Pose2 pose_map;       ///< its middle; x leads through it, in the direction asked for
  double width = 0;     ///< between the walls' surfaces [m]
  double distance = 0;  ///< of its middle from the point asked for [m]
};

/// What it costs to take a place for the one that is meant: the narrower and the nearer the better,
/// two metres away as bad as one metre wider. Narrower than a usual door earns nothing [m].
double costOfPlace(double width, double distance);

/// The narrow place that is meant by a point: between two wall pixels that no other one comes
/// between, not even into the circle around them (so that they face each other), the one that costs
/// least; a short way between two walls is met in its middle. Looks at the map as far as it needs
/// only; unknown space counts as wall, small clutter does not.
std::optional<NarrowPlace> findNarrowPlace(const OccupancyMap& map, const NarrowPlaceQuery& query);

}  // namespace agrid
