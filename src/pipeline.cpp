// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline.h"

#include <utility>

#include "agrid/areas/area_segmentation.h"

namespace agrid {

Structure extractStructure(std::shared_ptr<const OccupancyMap> map, const PipelineParams& params) {
  Walls walls = limitCells(detectWalls(*map, params.walls), params.grid);
  auto grid = std::make_shared<const AGrid>(constructGrid(walls));
  return {std::move(map), std::move(walls), std::move(grid)};
}

SemanticMap annotate(const Structure& structure, const std::vector<Tag>& given,
                     const PipelineParams& params) {
  std::vector<Tag> tags = given;
  for (Tag& tag : proposeTags(*structure.map, given, params.areas)) tags.push_back(std::move(tag));
  AreaMap area_map = segmentAreas(*structure.map, *structure.grid, tags, params.areas);
  TopologicalGraph graph = buildGraph(area_map);
  return {structure, std::move(tags), std::move(area_map), std::move(graph)};
}

}  // namespace agrid
