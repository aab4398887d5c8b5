// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/exchange/import.h"
#include "agrid/geometry/segment.h"

namespace agrid {

/// A door with a name, as in `doors.yaml` of utexas-bwi's maps.
struct PlaceDoor {
  std::string name;  ///< may be empty
  Segment jambs_map;
};

/// Reads a YAML list of {door_corner_pt_1: [x, y], door_corner_pt_2: [x, y], name}, map frame [m];
/// the name may be missing, other keys are passed over.
/// @throws FileError naming the path and the line
std::vector<PlaceDoor> readPlaceDoors(const std::string& path);

/// The tag that says that this door is there.
DoorTag tagOf(const PlaceDoor& door);

/// Reads `locations.yaml` as it lies beside them: `locations`, a list of names, and `polygons`, a
/// list [x1, y1, x2, y2, ...] of corners for each, in pixels of the map's image (y down from its
/// upper edge).
/// @throws FileError naming the path and the line
void readLocations(const std::string& path, const OccupancyMap& map, GivenPlace& place);

/// Reads `objects.yaml` as it lies beside them: a list of {name, point: [x, y, yaw]}, map frame.
/// @throws FileError naming the path and the line
std::vector<ObjectTag> readPlaceObjects(const std::string& path);

/// Reads a GeoJSON file in metres of the map's frame, ours or one drawn by people: features are
/// areas, doors or objects by their property `kind`, else polygons are areas, lines doors and
/// points objects.
/// @throws FileError naming the path and the feature
GivenPlace readGeoJson(const std::string& path, const OccupancyMap& map);

}  // namespace agrid
