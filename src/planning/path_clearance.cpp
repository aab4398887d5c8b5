// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "map/squared_distance.h"
#include "planning/path_facts.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

/// Beyond it the window around a pixel would be large, and nobody asks for the last pixel.
constexpr double kExactPx = 64;
/// The centres of two pixels are at most so much farther apart than a point of the one and the
/// square of the other.
constexpr double kTwoHalfDiagonals = 1.4143;

double pointToSegment(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

double pointToSquare(const Point2& p, Pixel square) {
  return std::hypot(std::max(std::abs(p.x() - square.x) - 0.5, 0.0),
                    std::max(std::abs(p.y() - square.y) - 0.5, 0.0));
}

/// Distance of a segment to a pixel's square. They never overlap: the segment's pixels are free.
double segmentToSquare(const Point2& a, const Point2& b, Pixel square) {
  double distance = std::min(pointToSquare(a, square), pointToSquare(b, square));
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      distance = std::min(distance, pointToSegment({square.x + x, square.y + y}, a, b));
    }
  }
  return distance;
}

struct Candidate {
  std::int32_t squared_distance;
  Pixel pixel;
  std::size_t segment;
};

std::vector<Candidate> candidates(const FreeSpace& free, const std::vector<FinePoint>& path) {
  std::vector<Candidate> list;
  for (std::size_t i = 0; i < path.size(); ++i) {
    walkTouched(path[i == 0 ? 0 : i - 1], path[i], [&](Pixel p) {
      if (free.geometry().contains(p)) list.push_back({free.squaredDistance(p), p, i});
      return true;
    });
  }
  std::stable_sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) {
    return a.squared_distance < b.squared_distance;
  });
  return list;
}

}  // namespace

double pathClearancePx(const FreeSpace& free, const Obstacles& obstacles,
                       const std::vector<FinePoint>& path) {
  const MapGeometry& geometry = free.geometry();
  double best = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates(free, path)) {
    const double distance = std::sqrt(candidate.squared_distance);
    const double bound = std::max(distance - kTwoHalfDiagonals, 0.0);
    if (bound >= best) break;
    if (distance > kExactPx) return candidate.squared_distance == kFarSquared ? best : bound;
    const auto reach = static_cast<int>(std::ceil(std::min(best, distance + 1) + 2));
    const Pixel c = candidate.pixel;
    const Point2 a = coordinates(path[candidate.segment == 0 ? 0 : candidate.segment - 1]);
    const Point2 b = coordinates(path[candidate.segment]);
    for (int y = std::max(c.y - reach, 0); y <= std::min(c.y + reach, geometry.height - 1); ++y) {
      for (int x = std::max(c.x - reach, 0); x <= std::min(c.x + reach, geometry.width - 1); ++x) {
        if (free.squaredDistance({x, y}) != 0 || !obstacles.at(geometry.index({x, y}))) continue;
        best = std::min(best, segmentToSquare(a, b, {x, y}));
      }
    }
  }
  return best;
}

}  // namespace agrid::planning
