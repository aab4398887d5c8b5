// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "agrid/geometry/pose2.h"
#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid::test {

/// Rooms on both sides of a corridor; the walls of the building frame, in pixels.
struct FloorPlan {
  Point2 size = Point2::Zero();
  std::vector<Segment> walls;
};

/// A wall from a to b with a doorway of 20 pixels in its middle.
inline void addWallWithDoor(FloorPlan& plan, const Point2& a, const Point2& b) {
  const Point2 along = (b - a).normalized() * 10;
  const Point2 middle = (a + b) / 2;
  plan.walls.push_back({a, middle - along});
  plan.walls.push_back({middle + along, b});
}

inline FloorPlan randomFloorPlan(std::mt19937& random) {
  std::uniform_int_distribution<int> room(45, 80);
  FloorPlan plan;
  plan.size = Point2(340, room(random) + room(random) + 30);
  const double low = room(random);
  const double high = low + 30;
  for (const double y : {0.0, plan.size.y()}) {
    plan.walls.push_back({Point2(0, y), Point2(plan.size.x(), y)});
  }
  for (const double x : {0.0, plan.size.x()}) {
    plan.walls.push_back({Point2(x, 0), Point2(x, plan.size.y())});
  }
  double from = 0;
  while (from < plan.size.x()) {
    double to = from + room(random);
    if (to > plan.size.x() - 40) to = plan.size.x();
    addWallWithDoor(plan, {from, low}, {to, low});
    addWallWithDoor(plan, {from, high}, {to, high});
    plan.walls.push_back({Point2(to, 0), Point2(to, low)});
    plan.walls.push_back({Point2(to, high), Point2(to, plan.size.y())});
    from = to;
  }
  return plan;
}

inline double distanceTo(const Segment& segment, const Point2& point) {
  const Point2 along = segment.b - segment.a;
  const double t =
      std::min(1.0, std::max(0.0, (point - segment.a).dot(along) / along.squaredNorm()));
  return (point - segment.a - t * along).norm();
}

/// The plan as a map, turned counter-clockwise about its middle: walls 3 pixels thick, unknown
/// outside.
inline OccupancyGrid drawPlan(const FloorPlan& plan, double turn_deg, double resolution = 0.05) {
  const int side = static_cast<int>(plan.size.norm()) + 20;
  const Pose2 image_from_middle{Point2(side / 2.0, side / 2.0), turn_deg * 3.14159265358979 / 180};
  const Pose2 plan_from_image = Pose2{plan.size / 2, 0} * inverse(image_from_middle);
  OccupancyGrid grid;
  grid.geometry = {side, side, resolution, Pose2{}};
  grid.values.resize(grid.geometry.pixelCount(), -1);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Point2 p = plan_from_image * Point2(x + 0.5, y + 0.5);
      std::int8_t& value = grid.values[grid.geometry.index({x, y})];
      if (p.x() > 0 && p.y() > 0 && p.x() < plan.size.x() && p.y() < plan.size.y()) value = 0;
      for (const Segment& wall : plan.walls) {
        if (distanceTo(wall, p) < 1.5) value = 100;
      }
    }
  }
  return grid;
}

}  // namespace agrid::test
