// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planning/cell_lookup.h"
#include "planning/endpoints.h"
#include "planning/level_cache.h"
#include "planning/obstacles.h"
#include "planning/ompl/swept_robot.h"
#include "planning/path_facts.h"
#include "planning/radius_level.h"
#include "planning/request_check.h"

namespace agrid::planning {

/// A request's ends on the map, once both are known to be connected.
struct Task {
  std::shared_ptr<const RadiusLevel> level;
  Endpoint start;
  Target target;
  bool goal_moved = false;
  std::optional<double> goal_yaw;
};

/// A normal answer other than success; caught in Planner, never seen outside.
struct Refusal {
  PlanStatus status;
  std::string message;
};

/// What Planner prepares once for a map, and the steps of an answer.
class PlannerCore {
 public:
  PlannerCore(std::shared_ptr<const SemanticMap> map, const PlannerParams& params);
  /// For another semantic map; what does not depend on what changed is shared with `former`.
  PlannerCore(std::shared_ptr<const SemanticMap> map, const PlannerParams& params,
              const PlannerCore& former);

  const SemanticMap& map() const { return *map_; }

  /// What is prepared for the query's radius.
  /// @throws Stopped
  std::shared_ptr<const RadiusLevel> level(const Query& query, const StopCheck& stop) const {
    return levels_->get(query.robot_radius, kNoneEntered, stop);
  }

  /// The component check: places start and goal, and proves that they are connected.
  /// @throws Refusal, Stopped
  Task taskOf(const PlanRequest& request, const Query& query, const StopCheck& stop) const;

  struct Path {
    std::vector<FinePoint> corners;  ///< each in sight of the next
    double length_bound_px = 0;      ///< no path is shorter
    std::vector<double> yaws = {};   ///< of the robot at the corners; none: along the path
  };
  /// A short path for a task.
  /// @throws Refusal, Stopped
  Path pathOf(const Task& task, const Query& query, std::uint32_t seed,
              const StopCheck& stop) const;

  /// A path for a robot with a turning radius or a footprint, along the path for one without.
  /// @throws Refusal, Stopped
  Path turningPathOf(const Task& task, const PlanRequest& request, const Query& query,
                     const Path& lead, const StopCheck& stop) const;

  /// A robot with a footprint, or without one a circle. Valid as long as this object.
  std::shared_ptr<const SweptRobot> robot(double radius, const Polygon& footprint,
                                          const StopCheck& stop) const;

  /// Everything that is said about a path.
  Plan planOf(const Task& task, const PlanRequest& request, const Path& path) const;

 private:
  /// Where a task begins, and under which terms.
  struct Departure {
    EndpointChoice starts;
    double robot_radius;
    double tolerance;
    std::uint16_t open_area;  ///< label of a forbidden area that the start lies in, or 0
    const StopCheck& stop;
  };
  Task taskToPoint(Task task, const Departure& from, const Point2& goal_map) const;
  Task taskToArea(Task task, const Departure& from, std::size_t area) const;
  EndpointChoice goalsAt(const RadiusLevel& level, const Departure& from,
                         const Point2& goal_map) const;
  std::shared_ptr<const SweptRobot> robotIn(const FreeSpace& free, const Polygon& footprint) const;
  std::size_t areaIndex(AreaId id) const;
  /// Of a forbidden area, by its label; 0 if there is none at a point.
  std::uint16_t forbiddenAt(const Point2& point_map) const;
  std::string whyApart(const Departure& from, const Target& goal) const;
  std::string forbiddenInTheWay(const Departure& from, const Target& goal,
                                const RadiusLevel& open) const;

  std::shared_ptr<const SemanticMap> map_;
  Obstacles obstacles_;
  CellLookup cells_;
  std::unique_ptr<LevelCache> levels_;
};

}  // namespace agrid::planning
