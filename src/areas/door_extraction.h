// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/grid/a_grid.h"
#include "areas/area_labels.h"
#include "tags/relief.h"

namespace agrid {

/// Finds the borders between the areas. A border that runs along the barrier of a door tag is that
/// door, with confidence 1 unless the tag is automatic; any other is a door or a passage by its
/// width, with the share of such borders that people would draw as its confidence (see separation).
/// @param warnings  gets a sentence for each door tag by a person that parts nothing
/// @return sorted by id; those without a tag are numbered from the top of the map to its bottom
std::vector<Door> findDoors(const AreaLabels& labels, const Relief& relief,
                            const MapGeometry& geometry, const AreaParams& params,
                            std::vector<std::string>& warnings);

}  // namespace agrid
