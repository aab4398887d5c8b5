// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/semantic_map.h"
#include "tools/stage_meter.h"

namespace agrid::tools {

/// Areas and doors as JSON: metres in the map's frame (doc/tool.md).
std::string graphJson(const SemanticMap& map);

/// Counts, costs of the stages and warnings as JSON.
std::string summaryJson(const SemanticMap& map, const std::vector<StageCost>& costs,
                        const std::vector<std::string>& warnings);

/// The borders between two areas; doors to the outside are left out.
std::vector<Door> doorsBetweenAreas(const AreaMap& areas);

/// The same borders, jamb to jamb.
std::vector<Segment> doorSegments(const AreaMap& areas);

}  // namespace agrid::tools
