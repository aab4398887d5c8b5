// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "agrid/evaluation/scores.h"
#include "areas/assignment.h"
#include "areas/room_borders.h"
#include "evaluation/label_overlap.h"

namespace agrid {
namespace {

constexpr double kMinBorder = 0.2;  // [m]

double distanceTo(const Segment& segment, const Point2& point) {
  const Point2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? (point - segment.a).dot(along) / square : 0;
  return (segment.a + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

/// A box around a true door; what lies farther from it than `reach` lies farther from the door.
class Surroundings {
 public:
  void add(const Point2& point) {
    low_ = low_.cwiseMin(point);
    high_ = high_.cwiseMax(point);
  }
  bool hold(const Point2& point, double reach) const {
    return (point.array() >= low_.array() - reach).all() &&
           (point.array() <= high_.array() + reach).all();
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Point2 low_{kInfinite, kInfinite};
  Point2 high_{-kInfinite, -kInfinite};
};

/// A true door that is near a door.
struct Near {
  std::size_t door = 0;
  std::size_t truth = 0;
  double distance = 0;  // [m]
};

/// Pairs farther apart than that are all alike: one of them must not decide over many near ones.
double farthest(double tolerance) { return 10 * tolerance; }

/// Pairs doors with true doors and counts the pairs within the tolerance.
DoorScores pairDoors(const std::vector<Near>& near, std::size_t doors, std::size_t true_doors,
                     double tolerance) {
  DoorScores scores;
  scores.doors = doors;
  scores.borders = true_doors;
  scores.is_true.resize(doors);
  std::vector<PairValue> candidates;
  for (const Near& pair : near) {
    const double value = farthest(tolerance) - pair.distance;
    if (value > 0) candidates.push_back({pair.door, pair.truth, value});
  }
  double hits = 0;
  for (const PairValue& pair : assignAtMostValue(candidates)) {
    if (pair.value < farthest(tolerance) - tolerance) continue;
    scores.is_true[pair.row] = true;
    ++hits;
  }
  if (scores.doors > 0) scores.precision = hits / static_cast<double>(scores.doors);
  if (scores.borders > 0) scores.recall = hits / static_cast<double>(scores.borders);
  return scores;
}

}  // namespace

DoorScores scoreDoors(const OccupancyMap& map, const std::vector<Segment>& doors_map,
                      const std::vector<std::uint16_t>& rooms, double tolerance) {
  checkSize("rooms", rooms, map);
  const MapGeometry& geometry = map.geometry();
  const Pose2 image_from_map = inverse(geometry.map_from_image);
  const auto borders = findRoomBorders(map, compact(rooms, kMinLabelPixels), kMinBorder);
  const auto placeOf = [&](const BorderPoint& point) {
    return Point2(point.position(geometry) * geometry.resolution);
  };
  std::vector<Near> near;
  for (std::size_t b = 0; b < borders.size(); ++b) {
    Surroundings surroundings;
    for (const BorderPoint& point : borders[b]) surroundings.add(placeOf(point));
    for (std::size_t d = 0; d < doors_map.size(); ++d) {
      const Point2 middle = image_from_map * doors_map[d].midpoint();
      if (!surroundings.hold(middle, farthest(tolerance))) continue;
      double nearest = farthest(tolerance);
      for (const BorderPoint& point : borders[b]) {
        nearest = std::min(nearest, (placeOf(point) - middle).norm());
      }
      near.push_back({d, b, nearest});
    }
  }
  return pairDoors(near, doors_map.size(), borders.size(), tolerance);
}

DoorScores scoreDoors(const std::vector<Segment>& doors_map,
                      const std::vector<Segment>& true_doors_map, double tolerance) {
  std::vector<Near> near;
  for (std::size_t t = 0; t < true_doors_map.size(); ++t) {
    Surroundings surroundings;
    surroundings.add(true_doors_map[t].a);
    surroundings.add(true_doors_map[t].b);
    for (std::size_t d = 0; d < doors_map.size(); ++d) {
      const Point2 middle = doors_map[d].midpoint();
      if (!surroundings.hold(middle, farthest(tolerance))) continue;
      near.push_back({d, t, distanceTo(true_doors_map[t], middle)});
    }
  }
  return pairDoors(near, doors_map.size(), true_doors_map.size(), tolerance);
}

}  // namespace agrid
