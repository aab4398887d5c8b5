// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "agrid/semantic_map.h"

namespace agrid {

/// The one area an object belongs to: the one that holds its centre; or else, where the object
/// itself is what the map shows there, the area whose outline goes round it, the smallest if there
/// are several; nullptr if none does.
const Area* areaOf(const SemanticMap& map, const ObjectTag& object);

}  // namespace agrid
