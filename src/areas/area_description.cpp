// SPDX-License-Identifier: BSD-3-Clause
#include "areas/area_description.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "areas/outline.h"
#include "tags/free_space.h"

namespace agrid {
namespace {

struct Measures {
  Pixel low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  Pixel high{-1, -1};  ///< of its bounding box, both included
  std::size_t size_px = 0;
  Pixel anchor;
  std::int32_t squared_clearance_px = 0;
};

std::vector<Measures> measure(const OccupancyMap& map, const AreaLabels& labels) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat1b is_free(geometry.height, geometry.width);
  std::transform(map.pixels().begin(), map.pixels().end(), is_free.begin(),
                 [](Occupancy o) { return o == Occupancy::kFree ? 1 : 0; });
  // squares will do, and take half the memory on the way
  const std::vector<std::int32_t> squared = squaredDistancesFromWalls(is_free);
  std::vector<Measures> measures(labels.tags.size());
  std::size_t index = 0;
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x, ++index) {
      const std::uint32_t label = labels.of_pixel[index];
      if (label == AreaLabels::kNone || is_free(y, x) == 0) continue;
      Measures& m = measures[label];
      m.low = {std::min(m.low.x, x), std::min(m.low.y, y)};
      m.high = {std::max(m.high.x, x), std::max(m.high.y, y)};
      ++m.size_px;
      if (squared[index] <= m.squared_clearance_px) continue;
      m.squared_clearance_px = squared[index];
      m.anchor = {x, y};
    }
  }
  return measures;
}

Polygon outlineOf(std::uint32_t label, const Measures& m, const MapGeometry& geometry,
                  const AreaLabels& labels) {
  const cv::Rect box(m.low.x, m.low.y, m.high.x - m.low.x + 1, m.high.y - m.low.y + 1);
  cv::Mat1b shape(box.size());
  for (int y = 0; y < box.height; ++y) {
    const std::uint32_t* row = &labels.of_pixel[geometry.index({box.x, box.y + y})];
    for (int x = 0; x < box.width; ++x) shape(y, x) = row[x] == label ? 1 : 0;
  }
  Polygon outline = traceOutline(shape);
  for (Point2& corner : outline) {
    corner = geometry.map_from_image * ((corner + Point2(box.x, box.y)) * geometry.resolution);
  }
  return outline;
}

}  // namespace

std::vector<Area> describeAreas(const OccupancyMap& map, const AreaLabels& labels) {
  const MapGeometry& geometry = map.geometry();
  const auto measures = measure(map, labels);
  std::vector<Area> areas;
  for (std::uint32_t i = 0; i < measures.size(); ++i) {
    const AreaTag& tag = labels.tags[i];
    const Measures& m = measures[i];
    Area area;
    area.id = tag.id;
    area.name = tag.name;
    area.category = tag.category;
    area.anchor_map = geometry.center(m.anchor);
    // from centre to centre; the wall begins half a pixel before
    area.anchor_clearance = (std::sqrt(m.squared_clearance_px) - 0.5) * geometry.resolution;
    area.outline_map = outlineOf(i, m, geometry, labels);
    area.size = static_cast<double>(m.size_px) * geometry.resolution * geometry.resolution;
    area.source = tag.source;
    area.properties = tag.properties;
    areas.push_back(std::move(area));
  }
  return areas;
}

}  // namespace agrid
