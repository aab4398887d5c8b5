// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/occupancy_map.h"
#include "areas/area_labels.h"

namespace agrid {

/// Measures each labelled area on the metric map as it is, clutter and all: anchor, outline, size.
std::vector<Area> describeAreas(const OccupancyMap& map, const AreaLabels& labels);

}  // namespace agrid
