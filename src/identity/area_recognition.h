// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/identity/recognition.h"
#include "identity/frames.h"

namespace agrid {

/// Puts a tag for each area of the new map into `result`, given tags without an area among those
/// that wait.
/// @return the id of each area, by its index
std::vector<AreaId> placeAreas(const FramedKnowledge& known, const SemanticMap& fresh,
                               const RecognitionParams& params, Recognition& result);

}  // namespace agrid
