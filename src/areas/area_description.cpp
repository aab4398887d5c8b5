// SPDX-License-Identifier: BSD-3-Clause
#include "areas/area_description.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "areas/outline.h"
#include "map/squared_distance.h"
#include "tags/pixel_runs.h"

namespace agrid {
namespace {

struct Measures {
  Pixel low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  Pixel high{-1, -1};  ///< of its bounding box, both included
  std::size_t size_px = 0;
  Pixel anchor;
  std::int32_t squared_clearance_px = 0;
  double clearance_sum_px = 0;
};

/// Adds the free pixels of a run of row `y`; rows come from the last to the first, the runs of a
/// row from the left.
void addPixels(const Occupancy* pixels, const std::int32_t* squared, cv::Range run, int y,
               Measures& m) {
  int size = 0;
  int last = 0;
  Pixel anchor{0, y};
  std::int32_t highest = -1;
  for (int x = run.start; x < run.end; ++x) {
    if (pixels[x] != Occupancy::kFree) continue;
    if (size++ == 0) m.low = {std::min(m.low.x, x), y};
    last = x;
    m.clearance_sum_px += std::sqrt(static_cast<double>(squared[x]));
    if (squared[x] <= highest) continue;
    highest = squared[x];
    anchor.x = x;
  }
  if (size == 0) return;
  m.high = {std::max(m.high.x, last), std::max(m.high.y, y)};
  m.size_px += static_cast<std::size_t>(size);
  // of several as good the first in row-major order
  if (highest < m.squared_clearance_px) return;
  if (highest == m.squared_clearance_px && m.anchor.y == y) return;
  m.squared_clearance_px = highest;
  m.anchor = anchor;
}

std::vector<Measures> measure(const OccupancyMap& map, const AreaLabels& labels) {
  static_assert(static_cast<int>(Occupancy::kFree) == 0 && sizeof(Occupancy) == 1,
                "any other value marks an obstacle");
  std::vector<Measures> measures(labels.tags.size());
  forEachRowOfSquaredDistances(
      map.geometry(), reinterpret_cast<const std::uint8_t*>(map.pixels().data()),
      Surroundings::kMarked, [&](int y, const std::int32_t* squared) {
        const std::size_t first = map.geometry().index({0, y});
        const Occupancy* pixels = map.pixels().data() + first;
        forEachRun(labels.of_pixel.data() + first, map.geometry().width,
                   [&](int begin, int end, std::uint32_t label) {
                     if (label == AreaLabels::kNone) return;
                     addPixels(pixels, squared, {begin, end}, y, measures[label]);
                   });
      });
  return measures;
}

Polygon outlineOf(std::uint32_t label, const Measures& m, const MapGeometry& geometry,
                  const AreaLabels& labels) {
  const cv::Rect box(m.low.x, m.low.y, m.high.x - m.low.x + 1, m.high.y - m.low.y + 1);
  cv::Mat1b shape(box.size());
  for (int y = 0; y < box.height; ++y) {
    const std::uint32_t* row = &labels.of_pixel[geometry.index({box.x, box.y + y})];
    std::transform(row, row + box.width, shape[y],
                   [&](std::uint32_t l) { return l == label ? 1 : 0; });
  }
  Polygon outline = traceOutline(shape);
  for (Point2& corner : outline) {
    corner = geometry.map_from_image * ((corner + Point2(box.x, box.y)) * geometry.resolution);
  }
  return outline;
}

}  // namespace

AreaMeasures describeAreas(const OccupancyMap& map, const AreaLabels& labels) {
  const MapGeometry& geometry = map.geometry();
  const auto measures = measure(map, labels);
  AreaMeasures result;
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
    result.areas.push_back(std::move(area));
    const double mean_px =
        m.size_px == 0 ? 0 : m.clearance_sum_px / static_cast<double>(m.size_px) - 0.5;
    result.mean_clearances.push_back(std::max(mean_px, 0.0) * geometry.resolution);
  }
  return result;
}

}  // namespace agrid
