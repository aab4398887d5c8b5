// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/map_geometry.h"

namespace agrid::tools {

/// A point of the map frame [m] in pixels of the map's image: pixel centres at integers, y down
/// from the top row.
Point2 imagePoint(const Point2& point_map, const MapGeometry& geometry);

/// The way back: a point in pixels of the map's image, in the map frame [m].
Point2 mapPoint(const Point2& image_px, const MapGeometry& geometry);

/// A line "x1,y1,x2,y2" for each segment, in image pixels, below a header.
std::string segmentsCsv(const std::vector<Segment>& segments_map, const MapGeometry& geometry);

/// A number as text, the same everywhere, with three decimals at most.
std::string shortNumber(double value);

}  // namespace agrid::tools
