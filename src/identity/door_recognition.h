// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/identity/recognition.h"
#include "identity/frames.h"

namespace agrid {

/// Puts a tag for each door of the new map into `result`, given tags without a door among those
/// that wait. A given door keeps the pose that it was given.
/// @param area_ids  of each area of the new map, see placeAreas
void placeDoors(const FramedKnowledge& known, const SemanticMap& fresh,
                const std::vector<AreaId>& area_ids, const RecognitionParams& params,
                Recognition& result);

}  // namespace agrid
