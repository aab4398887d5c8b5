// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/occupancy_map.h"
#include "areas/area_labels.h"

namespace agrid {

/// What is measured of areas on the metric map as it is, clutter and all.
struct AreaMeasures {
  std::vector<Area> areas;              ///< with anchor, outline and size
  std::vector<double> mean_clearances;  ///< of their free pixels, from what is not free [m]
};

/// Measures each labelled area.
AreaMeasures describeAreas(const OccupancyMap& map, const AreaLabels& labels);

}  // namespace agrid
