// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/pipeline.h"
#include "agrid/storage.h"

namespace agrid::tools {

/// A map and what is known about its place.
struct LaidKnowledge {
  SemanticMap map;
  Knowledge laid;                   ///< over it: what was known, or recognised
  std::vector<std::string> report;  ///< what changed if it was known on another map
};

/// Lays what is known of a place over a map of it as the node does: as it is if the map is the one
/// that it was last seen on, else what is recognised. The map's frame is taken to be that of
/// `known`.
LaidKnowledge layKnowledge(const Structure& structure, const StoredMap& known,
                           const PipelineParams& params, const StageListener& on_stage = {});

}  // namespace agrid::tools
