// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <cstdint>

#include <agrid_map/PlanAreas.h>
#include <agrid_map/PlanPath.h>
#include <agrid_map/TopologicalGraph.h>

#include "places.h"

namespace agrid_map_rviz {

/// A path to an area or an object of the graph.
/// @param start  id of the area from whose anchor it leads; 0: from the robot
agrid_map::PlanPath::Request pathRequest(const agrid_map::TopologicalGraph& graph,
                                         std::uint32_t start, const Place& goal);

/// Up to four ways there that differ in their doors.
agrid_map::PlanAreas::Request routesRequest(const agrid_map::TopologicalGraph& graph,
                                            std::uint32_t start, const Place& goal);

/// A path, or a way, as a line for people.
QString describe(const agrid_map::PlanPath::Response& response);
QString describe(const agrid_map::Route& route);

}  // namespace agrid_map_rviz
