// SPDX-License-Identifier: BSD-3-Clause
#include "planning/planner_core.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "planning/ompl/planner_by_name.h"
#include "planning/ompl/shorten.h"
#include "planning/road_search.h"
#include "planning/taut.h"
#include "planning/tighten.h"

namespace agrid::planning {
namespace {

/// A planner of OMPL that improves its paths may stop at so many times the length of ours.
constexpr double kGoodEnough = 1.05;

const std::shared_ptr<const SemanticMap>& requireMap(
    const std::shared_ptr<const SemanticMap>& map) {
  if (!map) throw std::invalid_argument("Planner: the map is null");
  return map;
}

std::unique_ptr<LevelCache> newLevels(const SemanticMap& map, const Obstacles& obstacles) {
  return std::make_unique<LevelCache>(map.map().geometry(), map.area_map, obstacles);
}

bool haveSamePixels(const SemanticMap& a, const SemanticMap& b) {
  return a.structure.map == b.structure.map || a.map().digest() == b.map().digest();
}

bool haveSameDoors(const std::vector<Door>& a, const std::vector<Door>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Door& x, const Door& y) {
    return x.jambs_map.a == y.jambs_map.a && x.jambs_map.b == y.jambs_map.b &&
           (x.state == DoorState::kClosed) == (y.state == DoorState::kClosed);
  });
}

void requireFree(const FreeSpace& free, const std::vector<FinePoint>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!free.canSee(path[i - 1], path[i])) throw std::logic_error("Planner: a path is not free");
  }
}

std::vector<PixelBox> boxesOf(const PortalGraph& regions, const Road& road) {
  std::vector<PixelBox> boxes;
  for (const std::uint32_t region : road.regions) boxes.push_back(regions.boxOf(region));
  return boxes;
}

}  // namespace

PlannerCore::PlannerCore(std::shared_ptr<const SemanticMap> map, const PlannerParams& params)
    : map_(requireMap(map)),
      obstacles_(*map_, params.allow_unknown, params.clearance),
      cells_(map_->map().geometry(), map_->grid()),
      levels_(newLevels(*map_, obstacles_)) {
  levels_->get(params.robot_radius, kNoneEntered, {});
}

PlannerCore::PlannerCore(std::shared_ptr<const SemanticMap> map, const PlannerParams& params,
                         const PlannerCore& former)
    : map_(requireMap(map)),
      obstacles_(*map_, params.allow_unknown, params.clearance),
      cells_(map_->map().geometry(), map_->grid()) {
  const AreaMap& areas = map_->area_map;
  const AreaMap& former_areas = former.map_->area_map;
  levels_ = haveSamePixels(*map_, *former.map_)
                ? std::make_unique<LevelCache>(*former.levels_, areas, obstacles_,
                                               haveSameDoors(areas.doors, former_areas.doors))
                : newLevels(*map_, obstacles_);
  levels_->get(params.robot_radius, kNoneEntered, {});
}

PlannerCore::Path PlannerCore::pathOf(const Task& task, const Query& query, std::uint32_t seed,
                                      const StopCheck& stop) const {
  const FreeSpace& free = task.level->free;
  const RadiusLevel& level = *task.level;
  const RoadSearch roads(level);
  Road road = roads.find({task.start.point, task.start.region, &task.target}, stop);
  pullTaut(free, level.roadmap, road);
  Path path;
  path.length_bound_px = road.length_bound_px;
  for (const RoadCorner& corner : road.corners) path.corners.push_back(corner.at);
  if (isOmplPlanner(query.planner) && path.corners.size() > 1) {
    const OmplQuery ompl{query.planner,
                         path.corners.front(),
                         path.corners.back(),
                         boxesOf(level.roadmap.regions(), road),
                         kGoodEnough * lengthPx(path.corners),
                         seed};
    path.corners = planByOmpl(free, ompl, stop);
    if (path.corners.empty()) {
      throw Refusal{PlanStatus::kTimeout,
                    query.planner + " found no path in time, though there is one"};
    }
    shortenByOmpl(free, seed, path.corners);
    tighten(free, path.corners);
  }
  requireFree(free, path.corners);
  return path;
}

}  // namespace agrid::planning
