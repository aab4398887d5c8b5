// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <nav_msgs/Path.h>

#include <agrid_map/AGrid.h>
#include <agrid_map/Route.h>
#include <agrid_map/TopologicalGraph.h>

#include "mesh.h"

namespace agrid_map_rviz {

/// The colour of an area, the same as in ~markers: the hue goes round by the golden ratio, so that
/// neighbouring ids are well apart. Opaque.
Color areaColor(std::uint32_t id);

/// Doors from jamb to jamb: red if closed, green if open, blue if nobody has said; passages paler;
/// the less sure, the more transparent.
Mesh doorShapes(const agrid_map::TopologicalGraph& graph);
/// Objects as their boxes, red.
Mesh objectShapes(const agrid_map::TopologicalGraph& graph);
/// What waits for a sure place, orange; only what lies in the frame of the graph.
Mesh pendingShapes(const agrid_map::TopologicalGraph& graph);
/// The graph: areas as nodes at their anchors, joined through the middle of their doors.
Mesh edgeShapes(const agrid_map::TopologicalGraph& graph);
/// The way of a route over the anchors of its areas and through the middle of its doors.
Mesh routeShapes(const agrid_map::TopologicalGraph& graph, const agrid_map::Route& route);
/// A path as a line.
Mesh planShapes(const nav_msgs::Path& plan);
/// The lines of the A-Grid, in the grid's own frame.
Mesh cellShapes(const agrid_map::AGrid& grid);

}  // namespace agrid_map_rviz
