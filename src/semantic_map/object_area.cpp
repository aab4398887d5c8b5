// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/object_area.h"

#include "semantic_map/shape.h"

namespace agrid {

const Area* areaOf(const SemanticMap& map, const ObjectTag& object) {
  const Point2& center = object.pose_map.position;
  if (const Area* area = areaAt(map, center)) return area;
  const Area* smallest = nullptr;
  for (const Area& area : map.area_map.areas) {
    const bool goes_round = !area.outline_map.empty() && contains(shapeOf(&area), center);
    if (goes_round && (!smallest || area.size < smallest->size)) smallest = &area;
  }
  return smallest;
}

}  // namespace agrid
