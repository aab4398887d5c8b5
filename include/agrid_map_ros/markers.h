// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "agrid/semantic_map.h"

namespace agrid_map_ros {

/// RViz refuses or stumbles over longer lists.
constexpr std::size_t kMaxMarkerPoints = 16000;

/// What RViz shows of a map. The first marker deletes all former ones; the namespaces are
/// - cells: the lines of the A-Grid;
/// - areas: the cells of each area, filled with a colour that follows from the area's id;
/// - doors: from jamb to jamb, blue; closed ones darker, passages lighter;
/// - graph: the anchors of the areas, joined through the midpoints of the doors;
/// - objects: their boxes, turned as they are, red; a small one for those without a size;
/// - pending: what waits for a sure place and lies in the map's frame, orange;
/// - names: of areas, at their anchors, and of objects.
/// Ids count up from 0 in each namespace; lists hold at most kMaxMarkerPoints points.
/// @param header  its frame is the map's
visualization_msgs::MarkerArray makeMarkers(const agrid::SemanticMap& map,
                                            const std_msgs::Header& header);

}  // namespace agrid_map_ros
