// SPDX-License-Identifier: BSD-3-Clause
#include "areas/door_extraction.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "tags/borders.h"
#include "tags/default_name.h"
#include "tags/region_graph.h"
#include "tags/separation.h"

namespace agrid {
namespace {

/// Merging leaves the borders whose score is high, the overrated ones among them: of those that are
/// left fewer are true than the score says. Their odds, on floor plans and drawn offices, are these
/// of it (doc/areas.md shows how far the result can be believed).
double believable(double separation) {
  constexpr double kOddsRatio = 0.22;
  const double odds = separation / (1 - separation) * kOddsRatio;
  return odds / (1 + odds);
}

class DoorFinder {
 public:
  DoorFinder(const AreaLabels& labels, const Relief& relief, const MapGeometry& geometry,
             const AreaParams& params)
      : labels_(labels),
        relief_(relief),
        geometry_(geometry),
        params_(params),
        stretches_(findOpenStretches()),
        graph_(labels.of_pixel, labels.tags.size(), stretches_,
               BorderSurvey(relief, labels.openings, geometry)) {}

  /// The doors of the barriers that have two areas beside them; the others' numbers go to `unused`.
  std::vector<Door> ofBarriers(std::vector<std::size_t>& unused) const {
    std::vector<Door> doors;
    for (std::size_t i = 0; i < at_barrier_.size(); ++i) {
      if (at_barrier_[i].empty()) {
        unused.push_back(i);
        continue;
      }
      const Barrier& barrier = relief_.barriers[i];
      const BorderPoint& sides = mostFrequentSides(at_barrier_[i]);
      Door door = between(sides, barrier.jambs_map);
      const double lower_clearance =
          std::min(graph_.shape(sides.a).clearance, graph_.shape(sides.b).clearance);
      door.confidence = std::clamp(1 - door.width / 2 / lower_clearance, 0., 1.);
      door.id = barrier.tag.id;
      door.name = barrier.tag.name;
      door.state = barrier.tag.state;
      door.source = barrier.tag.source;
      door.properties = barrier.tag.properties;
      if (door.source != TagSource::kAutomatic) {
        door.kind = DoorKind::kDoor;
        door.confidence = 1;
      }
      doors.push_back(std::move(door));
    }
    return doors;
  }

  std::vector<Door> ofOpenBorders() const {
    std::vector<Door> doors;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const BorderProfile& profile = graph_.profiles()[i];
      if (profile.extent < params_.min_border_length) continue;
      const auto inMap = [&](const Point2& point_px) {
        return Point2(geometry_.map_from_image * Point2(point_px * geometry_.resolution));
      };
      const BorderPoint& sides = stretches_[i].front();
      Door door = between(sides, {inMap(profile.jambs_px.a), inMap(profile.jambs_px.b)});
      door.confidence = believable(separation(graph_.measure(sides.a, sides.b)));
      doors.push_back(std::move(door));
    }
    return doors;
  }

 private:
  /// The borders that touch no barrier; the points of those that do go to their barriers.
  std::vector<Stretch> findOpenStretches() {
    std::unordered_map<std::size_t, std::size_t> barrier_of;
    for (std::size_t i = 0; i < relief_.barriers.size(); ++i) {
      for (const std::size_t pixel : relief_.barriers[i].pixels) barrier_of.emplace(pixel, i);
    }
    at_barrier_.resize(relief_.barriers.size());
    std::vector<BorderPoint> open_points;
    for (const BorderPoint& point : findBorderPoints(labels_.of_pixel, geometry_)) {
      auto barrier = barrier_of.find(point.pixel);
      if (barrier == barrier_of.end()) barrier = barrier_of.find(point.other);
      (barrier == barrier_of.end() ? open_points : at_barrier_[barrier->second]).push_back(point);
    }
    return splitIntoStretches(open_points, geometry_);
  }

  static const BorderPoint& mostFrequentSides(const Stretch& points) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> count;
    const BorderPoint* most = &points.front();
    for (const BorderPoint& point : points) ++count[{point.a, point.b}];
    for (const BorderPoint& point : points) {
      if (count[{point.a, point.b}] > count[{most->a, most->b}]) most = &point;
    }
    return *most;
  }

  Door between(const BorderPoint& sides, const Segment& jambs_map) const {
    Door door;
    door.jambs_map = jambs_map;
    door.width = jambs_map.length();
    door.kind = door.width <= params_.max_door_width ? DoorKind::kDoor : DoorKind::kPassage;
    door.areas = {labels_.tags[sides.a].id, labels_.tags[sides.b].id};
    return door;
  }

  const AreaLabels& labels_;
  const Relief& relief_;
  const MapGeometry& geometry_;
  const AreaParams& params_;
  std::vector<Stretch> at_barrier_;  ///< filled by findOpenStretches
  std::vector<Stretch> stretches_;
  RegionGraph graph_;
};

void numberDoors(std::vector<Door>& doors) {
  std::stable_sort(doors.begin(), doors.end(), [](const Door& a, const Door& b) {
    const Point2 p = a.jambs_map.midpoint();
    const Point2 q = b.jambs_map.midpoint();
    return p.y() != q.y() ? p.y() > q.y() : p.x() < q.x();
  });
  std::set<DoorId> used{DoorId{0}};
  std::set<std::string> names;
  for (const Door& door : doors) {
    used.insert(door.id);
    names.insert(door.name);
  }
  std::uint32_t next = 1;
  for (Door& door : doors) {
    if (door.id == DoorId{0}) {
      while (used.count(DoorId{next}) > 0) ++next;
      door.id = DoorId{next++};
    }
    if (!door.name.empty()) continue;
    door.name = defaultName("door", static_cast<std::uint32_t>(door.id), names);
  }
  std::stable_sort(doors.begin(), doors.end(),
                   [](const Door& a, const Door& b) { return a.id < b.id; });
}

}  // namespace

std::vector<Door> findDoors(const AreaLabels& labels, const Relief& relief,
                            const MapGeometry& geometry, const AreaParams& params,
                            std::vector<std::string>& warnings) {
  const DoorFinder finder(labels, relief, geometry, params);
  std::vector<std::size_t> unused;
  std::vector<Door> doors = finder.ofBarriers(unused);
  for (const std::size_t i : unused) {
    const DoorTag& tag = relief.barriers[i].tag;
    if (tag.source == TagSource::kAutomatic) continue;
    warnings.push_back("door tag " + std::to_string(static_cast<std::uint32_t>(tag.id)) + " '" +
                       tag.name + "' does not part two areas and is not used");
  }
  for (Door& door : finder.ofOpenBorders()) doors.push_back(std::move(door));
  numberDoors(doors);
  return doors;
}

}  // namespace agrid
