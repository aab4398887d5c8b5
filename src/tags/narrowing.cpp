// SPDX-License-Identifier: BSD-3-Clause
#include "tags/narrowing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace agrid {
namespace {

/// A wall pixel counts as opposite if it is seen from the border under at least this angle.
constexpr double kOppositeCosine = -0.3;

Point2 centerOf(Pixel p) { return {p.x + 0.5, p.y + 0.5}; }

/// Centres of the wall pixels within `reach` of a point; what lies beyond the map is wall.
std::vector<Point2> wallsAround(const Point2& center, double reach, const cv::Mat1f& height) {
  std::vector<Point2> walls;
  const auto low = [&](double v) { return static_cast<int>(std::floor(v - reach)); };
  const auto high = [&](double v) { return static_cast<int>(std::ceil(v + reach)); };
  for (int y = std::max(-1, low(center.y())); y <= std::min(height.rows, high(center.y())); ++y) {
    for (int x = std::max(-1, low(center.x())); x <= std::min(height.cols, high(center.x())); ++x) {
      const bool in_map = x >= 0 && y >= 0 && x < height.cols && y < height.rows;
      const Point2 wall = centerOf({x, y});
      if ((!in_map || height(y, x) <= 0) && (wall - center).norm() <= reach) walls.push_back(wall);
    }
  }
  return walls;
}

const Point2* nearestTo(const Point2& point, const std::vector<Point2>& candidates) {
  const Point2* nearest = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (const Point2& candidate : candidates) {
    const double distance = (candidate - point).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    nearest = &candidate;
  }
  return nearest;
}

std::vector<Point2> inDirection(const std::vector<Point2>& walls, const Point2& center,
                                const Point2& direction) {
  std::vector<Point2> found;
  for (const Point2& wall : walls) {
    const Point2 way = wall - center;
    if (way.dot(direction) >= -kOppositeCosine * way.norm()) found.push_back(wall);
  }
  return found;
}

/// The segment between the centres of two wall pixels, cut at their surfaces.
Segment betweenSurfaces(const Point2& a, const Point2& b) {
  const Point2 way = b - a;
  const double reach = std::max(std::abs(way.x()), std::abs(way.y()));
  if (reach <= 1) return {(a + b) / 2, (a + b) / 2};
  const Point2 half_pixel = way * (0.5 / reach);
  return {a + half_pixel, b - half_pixel};
}

}  // namespace

Segment findNarrowing(Pixel center_pixel, const cv::Mat1f& height) {
  const Point2 center = centerOf(center_pixel);
  const double reach = 2. * static_cast<double>(height(center_pixel.y, center_pixel.x)) + 2;
  const auto walls = wallsAround(center, reach, height);
  const Point2* nearest = nearestTo(center, walls);
  const Point2 direction = (*nearest - center).normalized();
  const auto one_side = inDirection(walls, center, direction);
  const auto other_side = inDirection(walls, center, -direction);
  const Point2* opposite = nearestTo(center, other_side);
  if (!opposite) return betweenSurfaces(*nearest, 2 * center - *nearest);
  for (bool moved = true; moved;) {
    const Point2* next = nearestTo(*opposite, one_side);
    moved = (*next - *opposite).norm() < (*nearest - *opposite).norm();
    if (moved) nearest = next;
    next = nearestTo(*nearest, other_side);
    if ((*next - *nearest).norm() < (*opposite - *nearest).norm()) {
      opposite = next;
      moved = true;
    }
  }
  return betweenSurfaces(*nearest, *opposite);
}

}  // namespace agrid
