// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "agrid/evaluation/scores.h"
#include "evaluation/label_overlap.h"
#include "evaluation/room_borders.h"

namespace agrid {
namespace {

constexpr double kMinBorder = 0.2;  // [m]

double distanceTo(const Segment& segment, const Point2& point) {
  const Point2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? (point - segment.a).dot(along) / square : 0;
  return (segment.a + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

/// @param distance  [m] of each door (row) from each true one (column)
DoorScores pairDoors(CostMatrix distance, double tolerance) {
  DoorScores scores;
  scores.doors = distance.rows;
  scores.borders = distance.columns;
  if (scores.doors == 0 || scores.borders == 0) return scores;
  // the cap keeps one far pair from deciding over many near ones
  for (double& d : distance.values) d = std::min(d, 10 * tolerance);
  double hits = 0;
  for (const auto& [d, t] : assignAtLeastCost(distance)) {
    hits += distance.at(d, t) <= tolerance ? 1 : 0;
  }
  scores.precision = hits / static_cast<double>(scores.doors);
  scores.recall = hits / static_cast<double>(scores.borders);
  return scores;
}

}  // namespace

DoorScores scoreDoors(const OccupancyMap& map, const std::vector<Segment>& doors_map,
                      const std::vector<std::uint16_t>& rooms, double tolerance) {
  checkSize("rooms", rooms, map);
  const MapGeometry& geometry = map.geometry();
  const auto borders = findRoomBorders(map, compact(rooms, kMinLabelPixels), kMinBorder);
  CostMatrix distance{doors_map.size(), borders.size(), {}};
  for (const Segment& door : doors_map) {
    const Point2 middle = inverse(geometry.map_from_image) * door.midpoint() / geometry.resolution;
    for (const Stretch& border : borders) {
      double nearest = 10 * tolerance;
      for (const BorderPoint& point : border) {
        const double d = (point.position(geometry) - middle).norm() * geometry.resolution;
        nearest = std::min(nearest, d);
      }
      distance.values.push_back(nearest);
    }
  }
  return pairDoors(std::move(distance), tolerance);
}

DoorScores scoreDoors(const std::vector<Segment>& doors_map,
                      const std::vector<Segment>& true_doors_map, double tolerance) {
  CostMatrix distance{doors_map.size(), true_doors_map.size(), {}};
  for (const Segment& door : doors_map) {
    for (const Segment& truth : true_doors_map) {
      distance.values.push_back(distanceTo(truth, door.midpoint()));
    }
  }
  return pairDoors(std::move(distance), tolerance);
}

}  // namespace agrid
