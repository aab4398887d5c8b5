// SPDX-License-Identifier: BSD-3-Clause
#include "identity/polygon_lookup.h"

#include <algorithm>
#include <cmath>

namespace agrid {

bool contains(const Polygon& polygon, const Point2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

double surface(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    twice += polygon[j].x() * polygon[i].y() - polygon[i].x() * polygon[j].y();
  }
  return std::abs(twice) / 2;
}

OutlineIndex::OutlineIndex(const std::vector<AreaTag>& areas) : areas_(areas) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const Polygon& outline = areas[i].outline_map;
    if (outline.empty()) continue;
    Box box{outline.front(), outline.front(), i, surface(outline)};
    for (const Point2& corner : outline) {
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
    boxes_.push_back(box);
  }
  std::stable_sort(boxes_.begin(), boxes_.end(),
                   [](const Box& a, const Box& b) { return a.size < b.size; });
}

std::optional<std::size_t> OutlineIndex::smallestAt(const Point2& point_map) const {
  for (const Box& box : boxes_) {
    const bool in_box = (point_map.array() >= box.low.array()).all() &&
                        (point_map.array() <= box.high.array()).all();
    if (in_box && contains(areas_[box.area].outline_map, point_map)) return box.area;
  }
  return std::nullopt;
}

}  // namespace agrid
