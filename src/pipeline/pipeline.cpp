// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline.h"

#include <utility>

#include "agrid/areas/area_segmentation.h"

namespace agrid {
namespace {

void tell(const StageListener& on_stage, const char* stage) {
  if (on_stage) on_stage(stage);
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
  std::vector<Tag> given(known.areas.begin(), known.areas.end());
  given.insert(given.end(), known.doors.begin(), known.doors.end());
  TaggedAreas areas = findAreas(*structure.map, *structure.grid, given, params.areas);
  Knowledge knowledge = known;
  for (const Tag& tag : areas.tags) apply(PutTag{tag}, knowledge);
  tell(on_stage, "graph");
  TopologicalGraph graph = buildGraph(areas.area_map);
  return {structure, std::move(knowledge), std::move(areas.area_map), std::move(graph)};
}

}  // namespace agrid
