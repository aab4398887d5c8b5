// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "planning/obstacles.h"
#include "planning/radius_level.h"
#include "planning/target.h"

namespace agrid::planning {

/// Where a path can start or end.
struct Endpoint {
  FinePoint point;
  std::uint32_t region = kNoNode;  ///< of the roadmap
  std::uint32_t component = 0;
  bool moved = false;
  double shift_px = 0;  ///< how far it was moved
};

/// The places that can stand for a requested one: itself if it is free, else the nearest centre of
/// a free pixel within the tolerance for each component, so that a move never causes a false 'no'.
struct EndpointChoice {
  std::vector<Endpoint> places;  ///< nearest first
  std::string problem;           ///< why there is none
};

EndpointChoice chooseEndpoints(const RadiusLevel& level, const Obstacles& obstacles,
                               const Point2& point_map, double tolerance);

/// The pair of places in one component that is moved least; none if there is no such pair.
std::optional<std::pair<Endpoint, Endpoint>> connectedPair(const EndpointChoice& start,
                                                           const EndpointChoice& goal);

/// An area as a target, whatever reaches it.
/// @param label  1 + index into AreaMap::areas
Target areaTarget(const RadiusLevel& level, std::uint16_t label);
/// The components that an area has pixels in.
std::set<std::uint32_t> componentsOf(const Target& target, const PortalGraph& regions);
/// What one of them has of it.
Target reachablePart(Target target, const PortalGraph& regions, std::uint32_t component);

}  // namespace agrid::planning
