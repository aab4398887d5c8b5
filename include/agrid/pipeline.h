// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
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

/// Metric map -> walls -> A-Grid (paper, Fig. 1).
Structure extractStructure(std::shared_ptr<const OccupancyMap> map, const PipelineParams& params);

/// A-Grid + tags -> areas, doors, labels -> topological graph (paper, 3.2).
/// @param given  what people and robots said; automatic tags are added for the rest
SemanticMap annotate(const Structure& structure, const std::vector<Tag>& given,
                     const PipelineParams& params);

}  // namespace agrid
