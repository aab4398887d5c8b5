// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline.h"

#include <utility>

#include "agrid/areas/area_segmentation.h"

namespace agrid {
namespace {

void tell(const StageListener& on_stage, const char* stage) {
  if (on_stage) on_stage(stage);
}

SemanticMap withTags(SemanticMap map, LaidTags laid) {
  map.graph = buildGraph(laid.area_map);
  map.area_map = std::move(laid.area_map);
  map.knowledge = std::move(laid.knowledge);
  map.groups = std::move(laid.groups);
  return map;
}

}  // namespace

Structure extractStructure(std::shared_ptr<const OccupancyMap> map, const PipelineParams& params,
                           const StageListener& on_stage) {
  tell(on_stage, "walls");
  Walls walls = limitCells(detectWalls(*map, params.walls), params.grid);
  tell(on_stage, "grid");
  auto grid = std::make_shared<const AGrid>(constructGrid(walls));
  return {std::move(map), std::move(walls), std::move(grid)};
}

SemanticMap annotate(const Structure& structure, const Knowledge& known,
                     const PipelineParams& params, const StageListener& on_stage) {
  tell(on_stage, "areas");
  SemanticMap map;
  map.structure = structure;
  map.automatic = findAutomaticAreas(*structure.map, *structure.grid, params.areas);
  LaidTags laid = layTags(*structure.map, *structure.grid, *map.automatic, nullptr, known);
  tell(on_stage, "graph");
  return withTags(std::move(map), std::move(laid));
}

SemanticMap retag(const SemanticMap& former, const Knowledge& known) {
  SemanticMap map;
  map.structure = former.structure;
  map.automatic = former.automatic;
  const FormerTags before{former.area_map, former.groups};
  return withTags(std::move(map),
                  layTags(former.map(), former.grid(), *former.automatic, &before, known));
}

}  // namespace agrid
