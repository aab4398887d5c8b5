// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/relations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dialogue/place.h"

namespace agrid::dialogue {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding = 1e-9;  // [rad]

bool isSide(Relation relation) { return relation >= Relation::kLeftOf; }

/// Judges how things lie to one landmark.
class Judge {
 public:
  Judge(const SemanticMap& map, const Question& question, const RelationParams& params)
      : map_(map), question_(question), params_(params) {}

  /// How far a thing is from the landmark, if it lies so as the question asks.
  /// @param toward  the direction that is asked for [rad]
  std::optional<double> judge(const Place& place, const Place& landmark, double toward) const {
    if (place.thing == landmark.thing) return std::nullopt;
    if (question_.relation == Relation::kIn) return in(place, landmark);
    if (question_.relation == Relation::kNearestTo) return nearest(place, landmark);
    if (surrounds(place, landmark) || surrounds(landmark, place)) return std::nullopt;
    if (question_.relation == Relation::kNear) return within(params_.near, place, landmark);
    if (question_.relation == Relation::kNextTo) return nextTo(place, landmark);
    if (!liesToward(place, landmark, toward)) return std::nullopt;
    if (!isSide(question_.relation)) return distanceBetween(place.shape, landmark.shape);
    const double distance = distanceBetween(place.shape, landmark.shape, params_.side_range);
    return distance <= params_.side_range ? std::optional(distance) : std::nullopt;
  }

 private:
  std::optional<double> in(const Place& place, const Place& landmark) const {
    const bool asked_for_doors = question_.kind == TagKind::kDoor || !question_.what.empty();
    const bool of_the_area = place.as<Door>() && asked_for_doors && shareAnArea(place, landmark);
    if (landmark.as<Area>() && (of_the_area || surrounds(landmark, place))) return 0;
    const bool on_it = landmark.as<ObjectTag>() && place.as<ObjectTag>() &&
                       contains(landmark.shape, place.center_map);
    return on_it ? std::optional(0.) : std::nullopt;
  }

  std::optional<double> nearest(const Place& place, const Place& landmark) const {
    const bool anything = !question_.kind && question_.what.empty();
    if (anything && (surrounds(place, landmark) || surrounds(landmark, place))) return std::nullopt;
    return distanceBetween(place.shape, landmark.shape);
  }

  std::optional<double> within(double limit, const Place& place, const Place& landmark) const {
    // what is behind a wall is not near, but an area's wall is the area's
    const bool walled_off = !place.as<Area>() && !landmark.as<Area>() && !place.areas.empty() &&
                            !landmark.areas.empty() && !shareAnArea(place, landmark);
    if (walled_off) return std::nullopt;
    const double distance = distanceBetween(place.shape, landmark.shape, limit);
    return distance <= limit ? std::optional(distance) : std::nullopt;
  }

  std::optional<double> nextTo(const Place& place, const Place& landmark) const {
    const bool joined =
        place.as<Area>() && landmark.as<Area>() ? haveADoor(place, landmark)
        : place.as<Door>() || landmark.as<Door>()
            ? (place.as<Area>() || landmark.as<Area>()) && shareAnArea(place, landmark)
            : false;
    if (joined) return distanceBetween(place.shape, landmark.shape);
    return within(params_.next_to, place, landmark);
  }

  bool haveADoor(const Place& a, const Place& b) const {
    const auto& doors = map_.area_map.doors;
    return std::any_of(doors.begin(), doors.end(), [&](const Door& door) {
      const std::array<AreaId, 2> ids = {a.as<Area>()->id, b.as<Area>()->id};
      return std::is_permutation(ids.begin(), ids.end(), door.areas.begin());
    });
  }

  bool liesToward(const Place& place, const Place& landmark, double toward) const {
    Point2 way = place.center_map - nearestPoint(landmark.shape, place.center_map);
    if (way.norm() < 1e-6) way = place.center_map - landmark.center_map;
    if (way.norm() < 1e-6) return false;
    const double off = std::remainder(std::atan2(way.y(), way.x()) - toward, 2 * kPi);
    return std::abs(off) <= params_.sector_half_angle_deg * kPi / 180 + kRounding;
  }

  const SemanticMap& map_;
  const Question& question_;
  const RelationParams& params_;
};

/// Where the question's direction points, as the landmark is looked at [rad].
double directionOf(Relation relation, const Place& landmark, const std::optional<Pose2>& robot,
                   const RelationParams& params) {
  if (!isSide(relation)) {
    const int quarters = static_cast<int>(relation) - static_cast<int>(Relation::kNorthOf);
    return params.north_yaw_deg * kPi / 180 - quarters * kPi / 2;
  }
  const Point2 look = landmark.center_map - robot->position;
  const bool own_side = look.norm() < 1e-6;  // its own left is where it heads to, turned
  const double ahead = own_side ? robot->yaw : std::atan2(look.y(), look.x());
  switch (relation) {
    case Relation::kLeftOf:
      return ahead + kPi / 2;
    case Relation::kRightOf:
      return ahead - kPi / 2;
    case Relation::kInFrontOf:
      return own_side ? ahead : ahead + kPi;
    default:
      return own_side ? ahead + kPi : ahead;
  }
}

std::vector<Place> landmarksOf(const SemanticMap& map, const Question& question,
                               const std::optional<Pose2>& robot) {
  if (question.place_is_robot) {
    if (question.relation != Relation::kIn) return {placeOf(map, *robot)};
    const Area* area = areaAt(map, robot->position);
    return area ? std::vector<Place>{placeOf(map, area)} : std::vector<Place>{};
  }
  std::vector<Place> landmarks;
  for (const Thing& thing : findThings(map, question.place, {true, true}).things) {
    landmarks.push_back(placeOf(map, thing));
  }
  return landmarks;
}

std::vector<Thing> candidatesOf(const SemanticMap& map, const Question& question) {
  std::vector<Thing> things;
  if (!question.what.empty()) {
    things = findThings(map, question.what, {true, true}).things;
  } else {
    for (const Area& area : map.area_map.areas) things.emplace_back(&area);
    for (const Door& door : map.area_map.doors) things.emplace_back(&door);
    for (const ObjectTag& object : map.knowledge.objects) things.emplace_back(&object);
  }
  const auto other = [&](const Thing& t) { return question.kind && kindOf(t) != question.kind; };
  things.erase(std::remove_if(things.begin(), things.end(), other), things.end());
  std::stable_sort(things.begin(), things.end(),
                   [](const Thing& a, const Thing& b) { return a.index() < b.index(); });
  return things;
}

}  // namespace

bool needsRobot(const Question& question) {
  return question.place_is_robot || isSide(question.relation);
}

std::string problemOf(const RelationParams& params) {
  const auto outside = [](const char* field, double value, double least, double most) {
    return std::string(field) + " is " + std::to_string(value) + ", must be in [" +
           std::to_string(least) + ", " + std::to_string(most) + "]";
  };
  const auto is_in = [](double value, double least, double most) {
    return value >= least && value <= most;  // not if it is NaN
  };
  if (!is_in(params.near, 0, 100)) return outside("near", params.near, 0, 100);
  if (!is_in(params.next_to, 0, 100)) return outside("next_to", params.next_to, 0, 100);
  if (!is_in(params.side_range, 0, 1000)) return outside("side_range", params.side_range, 0, 1000);
  if (!is_in(params.sector_half_angle_deg, 1, 90)) {
    return outside("sector_half_angle_deg", params.sector_half_angle_deg, 1, 90);
  }
  if (is_in(params.north_yaw_deg, -360, 360)) return {};
  return outside("north_yaw_deg", params.north_yaw_deg, -360, 360);
}

std::vector<Related> findRelated(const SemanticMap& map, const Question& question,
                                 const std::optional<Pose2>& robot, const RelationParams& params) {
  const std::string problem = problemOf(params);
  if (!problem.empty()) throw std::invalid_argument(problem);
  if (needsRobot(question) && !robot) throw std::invalid_argument("robot: its pose is not given");
  const std::vector<Place> landmarks = landmarksOf(map, question, robot);
  const Judge judge(map, question, params);
  std::vector<Related> related;
  for (const Thing& thing : candidatesOf(map, question)) {
    const Place place = placeOf(map, thing);
    std::optional<double> least;
    for (const Place& landmark : landmarks) {
      const auto distance =
          judge.judge(place, landmark, directionOf(question.relation, landmark, robot, params));
      if (distance && (!least || *distance < *least)) least = distance;
    }
    if (least) related.push_back({thing, *least});
  }
  std::stable_sort(related.begin(), related.end(),
                   [](const Related& a, const Related& b) { return a.distance < b.distance; });
  if (question.relation == Relation::kNearestTo && related.size() > 1) related.resize(1);
  return related;
}

}  // namespace agrid::dialogue
