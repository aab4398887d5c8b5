// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "areas/automatic_areas.h"

namespace agrid {

/// Automatic areas as one, without what tags say: put together from what is known of each.
Area joinedArea(const std::vector<std::uint16_t>& members, const AutomaticAreas& automatic,
                const MapGeometry& geometry);

}  // namespace agrid
