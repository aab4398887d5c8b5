// SPDX-License-Identifier: BSD-3-Clause
#include "tags/borders.h"

#include <algorithm>
#include <cstring>
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
  const auto columns = static_cast<std::size_t>(geometry.width);
  std::vector<BorderPoint> points;
  std::vector<std::uint8_t> parts(columns);
  // compares each pixel of a row with the one `step` further on; the first loop has no branches,
  // so that the compiler can take several pixels at once
  const auto compareRow = [&](std::size_t first, std::size_t count, std::size_t step) {
    const std::uint32_t* row = labels.data() + first;
    for (std::size_t x = 0; x < count; ++x) {
      const std::uint32_t a = row[x];
      const std::uint32_t b = row[x + step];
      parts[x] = static_cast<std::uint8_t>((a != b) & (a != Basins::kNone) & (b != Basins::kNone));
    }
    for (std::size_t x = 0; x < count; ++x) {
      const void* found = std::memchr(&parts[x], 1, count - x);
      if (!found) break;
      x = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - parts.data());
      const std::size_t i = first + x;
      points.push_back(
          {std::min(row[x], row[x + step]), std::max(row[x], row[x + step]), i, i + step});
    }
  };
  for (std::size_t first = 0; first < labels.size(); first += columns) {
    compareRow(first, columns - 1, 1);
    if (first + columns < labels.size()) compareRow(first, columns, columns);
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
