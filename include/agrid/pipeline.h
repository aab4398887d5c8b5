// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "agrid/grid/grid_construction.h"
#include "agrid/semantic_map.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// Every parameter of the pipeline.
struct PipelineParams {
  WallParams walls;
  GridParams grid;
  AreaParams areas;
};

/// Is told the name of each stage when it begins: walls, grid, areas, graph.
using StageListener = std::function<void(const std::string&)>;

/// Metric map -> walls -> A-Grid (paper, Fig. 1).
Structure extractStructure(std::shared_ptr<const OccupancyMap> map, const PipelineParams& params,
                           const StageListener& on_stage = {});

/// A-Grid + tags -> areas, doors, labels -> topological graph (paper, 3.2).
/// @param known  what people and robots said, and what was found before; automatic tags are added
///               for the rest, with ids that were never used
SemanticMap annotate(const Structure& structure, const Knowledge& known,
                     const PipelineParams& params, const StageListener& on_stage = {});

/// The same as annotating the structure of `former` with other knowledge, bit for bit, at the cost
/// of what that changes.
SemanticMap retag(const SemanticMap& former, const Knowledge& known);

}  // namespace agrid
