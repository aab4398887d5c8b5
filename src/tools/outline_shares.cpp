// SPDX-License-Identifier: BSD-3-Clause
#include "tools/outline_shares.h"

#include <algorithm>
#include <cmath>

#include "identity/polygon_lookup.h"

namespace agrid::tools {
namespace {

constexpr double kLineDistance = 0.02;  // [m]
constexpr double kMostLines = 400;

struct Box {
  Point2 low = Point2::Zero();
  Point2 high = Point2::Zero();
  std::size_t area = 0;
};

Box boxOf(const Polygon& outline, std::size_t area) {
  Box box{outline.front(), outline.front(), area};
  for (const Point2& corner : outline) {
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

/// Where a line along x crosses the outline, in order: inside between the first and the second, the
/// third and the fourth ...
std::vector<double> crossingsAt(double y, const Polygon& outline) {
  std::vector<double> crossings;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point2& p = outline[i];
    const Point2& q = outline[j];
    if ((p.y() > y) == (q.y() > y)) continue;
    crossings.push_back(p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

double commonLength(const std::vector<double>& a, const std::vector<double>& b) {
  double length = 0;
  for (std::size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    length += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return length;
}

std::vector<Box> boxesOf(const std::vector<AreaTag>& areas) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i].outline_map.size() >= 3) boxes.push_back(boxOf(areas[i].outline_map, i));
  }
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const Box& x, const Box& y) { return x.low.x() < y.low.x(); });
  return boxes;
}

}  // namespace

double commonSurface(const Polygon& a, const Polygon& b) {
  if (a.size() < 3 || b.size() < 3) return 0;
  const Box box_a = boxOf(a, 0);
  const Box box_b = boxOf(b, 0);
  const double low = std::max(box_a.low.y(), box_b.low.y());
  const double height = std::min(box_a.high.y(), box_b.high.y()) - low;
  if (!(height > 0)) return 0;
  const double lines = std::min(kMostLines, std::ceil(height / kLineDistance));
  double length = 0;
  for (double line = 0; line < lines; ++line) {
    const double y = low + (line + 0.5) * height / lines;
    length += commonLength(crossingsAt(y, a), crossingsAt(y, b));
  }
  return length * height / lines;
}

double OutlineShare::overUnion() const {
  return of_a > 0 && of_b > 0 ? 1 / (1 / of_a + 1 / of_b - 1) : 0;
}

std::vector<OutlineShare> outlineShares(const std::vector<AreaTag>& a,
                                        const std::vector<AreaTag>& b) {
  std::vector<OutlineShare> shares;
  const std::vector<Box> boxes_b = boxesOf(b);
  for (const Box& box_a : boxesOf(a)) {
    const Polygon& outline_a = a[box_a.area].outline_map;
    for (const Box& box_b : boxes_b) {
      if (box_b.low.x() > box_a.high.x()) break;
      const Polygon& outline_b = b[box_b.area].outline_map;
      const bool apart = box_b.high.x() < box_a.low.x() || box_b.high.y() < box_a.low.y() ||
                         box_b.low.y() > box_a.high.y();
      const double common = apart ? 0 : commonSurface(outline_a, outline_b);
      if (!(common > 0)) continue;
      shares.push_back({box_a.area, box_b.area, std::min(1.0, common / surface(outline_a)),
                        std::min(1.0, common / surface(outline_b))});
    }
  }
  std::sort(shares.begin(), shares.end(), [](const OutlineShare& x, const OutlineShare& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return shares;
}

}  // namespace agrid::tools
