// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/geometry/segment.h"

namespace agrid::tools {

/// Reads a YAML (or JSON) list of {name, polygon: [[x, y], ...]}, map frame [m].
/// @throws FileError naming the path and the line
std::vector<Polygon> readRoomPolygons(const std::string& path);

/// Reads the jambs of a YAML list of {door_corner_pt_1: [x, y], door_corner_pt_2: [x, y]}, map
/// frame [m]; other keys are passed over.
/// @throws FileError naming the path and the line
std::vector<Segment> readDoorCorners(const std::string& path);

}  // namespace agrid::tools
