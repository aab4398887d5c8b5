// SPDX-License-Identifier: BSD-3-Clause
#include "planning/path_facts.h"

#include <algorithm>
#include <limits>

#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

double distanceToSegment(const Segment& segment, const Point2& p) {
  const Point2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - segment.a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (segment.a + t * along - p).norm();
}

}  // namespace

std::vector<Pixel> crossedPixels(const std::vector<FinePoint>& path) {
  std::vector<Pixel> pixels{path.front().pixel()};
  const auto add = [&](Pixel p) {
    if (p != pixels.back()) pixels.push_back(p);
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    const SegmentRaster raster(path[i - 1], path[i]);
    for (int c = raster.first();; c += raster.step()) {
      const SegmentRaster::Rows rows = raster.crossed(c);
      for (int n = 0; n <= rows.high - rows.low; ++n) {
        add(raster.pixel(c, raster.rising() ? rows.low + n : rows.high - n));
      }
      if (c == raster.last()) break;
    }
  }
  return pixels;
}

std::size_t doorBetween(const AreaMap& areas, std::size_t a, std::size_t b,
                        const Point2& near_map) {
  const AreaId id_a = areas.areas[a].id;
  const AreaId id_b = areas.areas[b].id;
  std::size_t nearest = kNoDoor;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < areas.doors.size(); ++d) {
    const auto& sides = areas.doors[d].areas;
    const bool joins =
        (sides[0] == id_a && sides[1] == id_b) || (sides[0] == id_b && sides[1] == id_a);
    const double distance = joins ? distanceToSegment(areas.doors[d].jambs_map, near_map) : least;
    if (!(distance < least)) continue;
    least = distance;
    nearest = d;
  }
  return nearest;
}

Route crossedAreas(const SemanticMap& map, const std::vector<Pixel>& pixels) {
  const MapGeometry& geometry = map.map().geometry();
  Route route;
  for (const Pixel p : pixels) {
    const std::uint16_t label = map.area_map.pixel_labels[geometry.index(p)];
    if (label == 0) continue;
    const std::size_t area = label - std::size_t{1};
    if (!route.areas.empty() && route.areas.back() == area) continue;
    if (!route.areas.empty()) {
      route.doors.push_back(
          doorBetween(map.area_map, route.areas.back(), area, geometry.center(p)));
    }
    route.areas.push_back(area);
  }
  return route;
}

}  // namespace agrid::planning
