// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "tags/near_points.h"
#include "tags/openings.h"

namespace agrid {
namespace {

constexpr double kMinWidth = 0.4;          // [m]
constexpr double kMaxWidth = 3;            // [m]
constexpr double kMaxWall = 4;             // [m]
constexpr double kMinArm = 0.15;           // [m]
constexpr double kParallelCosine = 0.866;  // 30 degrees
constexpr double kSpreadSine = 0.342;      // 20 degrees
constexpr double kStraightCosine = -0.94;

/// A corner that free space goes around: by more than half a turn.
struct Edge {
  Point2 point;
  std::array<Point2, 2> arms;  ///< unit vectors
};

std::vector<Edge> findEdges(const std::vector<WallCorner>& corners, const WallDirections& walls,
                            const Sight& sight) {
  constexpr double kLook = 2.5;  // [px]
  std::vector<Edge> edges;
  for (const WallCorner& corner : corners) {
    const double shorter = std::min(corner.arms[0].norm(), corner.arms[1].norm());
    if (sight.metres(shorter) < kMinArm) continue;
    const auto before = walls.align(corner.arms[0]);
    const auto beyond = walls.align(corner.arms[1]);
    if (!before || !beyond) continue;
    const Edge edge{corner.point, {*before, *beyond}};
    if (edge.arms[0].dot(edge.arms[1]) < kStraightCosine) continue;
    const Point2 away = -(edge.arms[0] + edge.arms[1]).normalized();
    if (sight.isWall(edge.point - away * kLook) && !sight.isWall(edge.point + away * kLook)) {
      edges.push_back(edge);
    }
  }
  return edges;
}

/// Whether the walls at both ends of a line run along each other on one side of it and spread on
/// the other.
bool isMouth(const Edge& a, const Edge& b, const Point2& direction) {
  const Point2 normal(-direction.y(), direction.x());
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const double along_a = a.arms[i].dot(normal);
      const double along_b = b.arms[j].dot(normal);
      const bool is_parallel = along_a * along_b > 0 && std::abs(along_a) >= kParallelCosine &&
                               std::abs(along_b) >= kParallelCosine;
      if (is_parallel && a.arms[1 - i].dot(direction) <= -kSpreadSine &&
          b.arms[1 - j].dot(direction) >= kSpreadSine) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<Opening> findMouths(const std::vector<WallCorner>& corners, const WallDirections& walls,
                                const Sight& sight) {
  const std::vector<Edge> edges = findEdges(corners, walls, sight);
  const double max_width = sight.pixels(kMaxWidth);
  const double reach = sight.pixels(kMaxWall);
  NearPoints near(max_width);
  std::vector<Opening> mouths;
  for (std::size_t j = 0; j < edges.size(); ++j) {
    near.forEachNear(edges[j].point, [&](std::size_t i) {
      const Point2 way = edges[j].point - edges[i].point;
      const double width = way.norm();
      if (width > max_width || width < sight.pixels(kMinWidth)) return;
      const Point2 direction = way / width;
      if (!isMouth(edges[i], edges[j], direction)) return;
      if (sight.freeRun(edges[i].point + direction, direction, width - 2) < width - 2.5) return;
      Opening mouth;
      // corners are pixels of free space; the jambs lie on the walls' surface
      const Point2& a = edges[i].point;
      const Point2& b = edges[j].point;
      mouth.jambs = {a - direction * sight.freeRun(a, -direction, 1.5),
                     b + direction * sight.freeRun(b, direction, 1.5)};
      mouth.wall_before = sight.wallRun(mouth.jambs.a - direction * 0.25, -direction, reach);
      mouth.wall_beyond = sight.wallRun(mouth.jambs.b + direction * 0.25, direction, reach);
      mouth.merit = std::min(sight.metres(mouth.wall_before), 0.5) +
                    std::min(sight.metres(mouth.wall_beyond), 0.5) + 0.5 - sight.metres(width) / 2;
      mouths.push_back(mouth);
    });
    near.add(edges[j].point, j);
  }
  return mouths;
}

}  // namespace agrid
