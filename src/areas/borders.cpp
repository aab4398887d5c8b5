// SPDX-License-Identifier: BSD-3-Clause
#include "areas/borders.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "tags/basins.h"
#include "tags/disjoint_sets.h"

namespace agrid {
namespace {

constexpr int kMaxGapPx = 3;

/// Splits the points from `begin` to `end`, all of one pair of areas.
void splitPair(const BorderPoint* begin, const BorderPoint* end, const MapGeometry& geometry,
               std::vector<Stretch>& stretches) {
  const auto count = static_cast<std::uint32_t>(end - begin);
  std::unordered_map<std::size_t, std::uint32_t> at_pixel;
  DisjointSets sets(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [found, is_new] = at_pixel.emplace(begin[i].pixel, i);
    if (!is_new) sets.unite(found->second, i);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const Pixel p = geometry.pixel(begin[i].pixel);
    for (int y = p.y; y <= p.y + kMaxGapPx; ++y) {
      for (int x = p.x - kMaxGapPx; x <= p.x + kMaxGapPx; ++x) {
        if (!geometry.contains({x, y})) continue;
        const auto near = at_pixel.find(geometry.index({x, y}));
        if (near != at_pixel.end()) sets.unite(i, near->second);
      }
    }
  }
  std::unordered_map<std::uint32_t, std::size_t> stretch_of;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [found, is_new] = stretch_of.emplace(sets.find(i), stretches.size());
    if (is_new) stretches.emplace_back();
    stretches[found->second].push_back(begin[i]);
  }
}

}  // namespace

std::vector<BorderPoint> findBorderPoints(const std::vector<std::uint32_t>& labels,
                                          const MapGeometry& geometry) {
  std::vector<BorderPoint> points;
  const auto compare = [&](std::size_t i, std::size_t j) {
    const std::uint32_t a = labels[i];
    const std::uint32_t b = labels[j];
    if (a == b || a == Basins::kNone || b == Basins::kNone) return;
    points.push_back({std::min(a, b), std::max(a, b), i, j});
  };
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const std::size_t i = geometry.index({x, y});
      if (x + 1 < geometry.width) compare(i, i + 1);
      if (y + 1 < geometry.height) compare(i, i + static_cast<std::size_t>(geometry.width));
    }
  }
  std::sort(points.begin(), points.end(), [](const BorderPoint& p, const BorderPoint& q) {
    return std::tie(p.a, p.b, p.pixel, p.other) < std::tie(q.a, q.b, q.pixel, q.other);
  });
  return points;
}

std::vector<Stretch> splitIntoStretches(const std::vector<BorderPoint>& points,
                                        const MapGeometry& geometry) {
  std::vector<Stretch> stretches;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && points[end].a == points[begin].a &&
           points[end].b == points[begin].b) {
      ++end;
    }
    splitPair(points.data() + begin, points.data() + end, geometry, stretches);
  }
  return stretches;
}

double extentOf(const Stretch& stretch, const MapGeometry& geometry) {
  Point2 low = stretch.front().position(geometry);
  Point2 high = low;
  for (const BorderPoint& point : stretch) {
    low = low.cwiseMin(point.position(geometry));
    high = high.cwiseMax(point.position(geometry));
  }
  return (high - low).norm() + 1;
}

}  // namespace agrid
