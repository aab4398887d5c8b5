// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/areas/laid_tags.h"
#include "agrid/grid/a_grid.h"
#include "agrid/grid/wall_detection.h"
#include "agrid/map/occupancy_map.h"
#include "agrid/tags/knowledge.h"
#include "agrid/topology/topological_graph.h"

namespace agrid {

/// What the geometry of a map alone says (paper, Fig. 1).
struct Structure {
  std::shared_ptr<const OccupancyMap> map;
  Walls walls;
  std::shared_ptr<const AGrid> grid;
};

/// The result: a map with its meaning. A value, never changed after it was made.
struct SemanticMap {
  Structure structure;
  Knowledge knowledge;  ///< a tag for each area and door, given or automatic; objects; what waits
  AreaMap area_map;
  TopologicalGraph graph;
  // what the areas are made from, to lay other tags over it: see layTags
  std::shared_ptr<const AutomaticAreas> automatic;
  std::vector<AreaGroup> groups;

  const OccupancyMap& map() const { return *structure.map; }
  const AGrid& grid() const { return *structure.grid; }
};

/// The area with this id, or nullptr.
const Area* findArea(const SemanticMap& map, AreaId id);
/// The area that holds a point of the map frame [m], or nullptr.
const Area* areaAt(const SemanticMap& map, const Point2& point_map);
/// All that holds in a cell (paper, 4: "annotated with a set of symbols"): the name and category of
/// its area and of the objects that overlap it, the names of its doors; sorted, each once.
std::vector<std::string> symbolsAt(const SemanticMap& map, Cell cell);

}  // namespace agrid
