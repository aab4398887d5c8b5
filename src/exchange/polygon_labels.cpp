// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/polygon_labels.h"

#include <algorithm>
#include <cmath>

namespace agrid {
namespace {

/// Where the rings cross a row of pixel centres, from the left.
std::vector<double> crossingsOf(const std::vector<Polygon>& rings_px, double y) {
  std::vector<double> crossings;
  for (const Polygon& ring : rings_px) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

void paintPolygon(const std::vector<Polygon>& rings_px, std::uint16_t label,
                  const OccupancyMap& map, std::vector<std::uint16_t>& labels) {
  const MapGeometry& geometry = map.geometry();
  const auto column = [&](double x) {
    return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, geometry.width * 1.0)));
  };
  for (int y = 0; y < geometry.height; ++y) {
    const std::vector<double> crossings = crossingsOf(rings_px, y + 0.5);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      for (int x = column(crossings[i]); x < column(crossings[i + 1]); ++x) {
        std::uint16_t& here = labels[geometry.index({x, y})];
        if (here == 0 && map.isFree({x, y})) here = label;
      }
    }
  }
}

Polygon pixelRing(const Polygon& ring_map, const MapGeometry& geometry) {
  const Pose2 image_from_map = inverse(geometry.map_from_image);
  Polygon ring;
  for (const Point2& p : ring_map) ring.push_back(image_from_map * p / geometry.resolution);
  return ring;
}

}  // namespace agrid
