// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map.h"

#include <algorithm>
#include <set>

#include "agrid/semantic_map/object_cells.h"

namespace agrid {

const Area* findArea(const SemanticMap& map, AreaId id) {
  const auto& areas = map.area_map.areas;
  const auto found =
      std::find_if(areas.begin(), areas.end(), [&](const Area& a) { return a.id == id; });
  return found == areas.end() ? nullptr : &*found;
}

const Area* areaAt(const SemanticMap& map, const Point2& point_map) {
  const MapGeometry& geometry = map.map().geometry();
  const auto pixel = geometry.pixelAt(point_map);
  if (!pixel) return nullptr;
  const std::uint16_t label = map.area_map.pixel_labels[geometry.index(*pixel)];
  return label == 0 ? nullptr : &map.area_map.areas[label - 1U];
}

std::vector<std::string> symbolsAt(const SemanticMap& map, Cell cell) {
  const AGrid& grid = map.grid();
  const auto index = static_cast<std::uint32_t>(grid.index(cell));
  std::set<std::string> symbols;
  if (const Area* area = findArea(map, map.area_map.cell_areas[index])) {
    symbols.insert(area->name);
    if (!area->category.empty()) symbols.insert(area->category);
  }
  for (const Door& door : map.area_map.doors) {
    if (std::binary_search(door.cells.begin(), door.cells.end(), index)) symbols.insert(door.name);
  }
  for (const ObjectTag& object : map.knowledge.objects) {
    if (!overlaps(grid, object, cell)) continue;
    symbols.insert(object.name);
    if (!object.category.empty()) symbols.insert(object.category);
  }
  return {symbols.begin(), symbols.end()};
}

}  // namespace agrid
