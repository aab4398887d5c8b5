// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "agrid/geometry/polygon.h"
#include "agrid/semantic_map.h"
#include "agrid/topology/route.h"

namespace agrid {

namespace planning {
struct PlannerAccess;
}

/// Which pixels a robot's centre may be in.
enum class Clearance {
  kCostmap,  ///< centre farther than the radius from the nearest obstacle pixel's centre
             ///< (costmap_2d)
  kStrict    ///< every point of the pixel farther than the radius from every obstacle's square
};

/// How a robot drives.
enum class Motion {
  kReedsShepp,  ///< forwards and backwards (Reeds and Shepp 1990)
  kDubins       ///< forwards only (Dubins 1957)
};

struct PlannerParams {
  double robot_radius = 0.2;  ///< [m]
  Clearance clearance = Clearance::kCostmap;
  bool allow_unknown = false;           ///< unknown space is no obstacle
  double timeout = 5;                   ///< [s], at most 60
  std::string planner = "AGrid";        ///< or a geometric planner of OMPL such as RRTConnect
  double turning_radius = 0;            ///< [m]; 0: the robot turns on the spot
  Motion motion = Motion::kReedsShepp;  ///< with a turning radius or a footprint
  /// Outline in the robot's frame, around its origin [m], instead of the circle of `robot_radius`:
  /// no pixel that it touches may be an obstacle. Empty: the circle.
  Polygon footprint;
};

/// What is wrong with parameters, naming field, value and bound; empty if nothing is.
std::string problemOf(const PlannerParams& params);

/// Every name that `PlannerParams::planner` and `PlanRequest::planner` may have, sorted.
std::vector<std::string> plannerNames();

/// A pose for planning: without a heading any one will do.
struct PlanPoint {
  Point2 position_map = Point2::Zero();  ///< [m]
  std::optional<double> yaw;             ///< [rad], map frame
};

/// To any point of an area (the nearest by path), or to its anchor.
struct AreaGoal {
  AreaId area{};
  bool at_anchor = false;
};

struct PlanRequest {
  PlanPoint start;
  std::variant<PlanPoint, AreaGoal> goal;
  double tolerance = 0;                  ///< how far start and goal may be moved to free space [m]
  std::optional<double> robot_radius;    ///< of a circle [m], 0 is a point; none: the parameters
  std::optional<double> turning_radius;  ///< [m]; none: the parameter
  std::optional<double> timeout;         ///< [s], in (0, 60]; none: the parameter
  std::optional<std::string> planner;    ///< none: the parameter
  std::uint32_t seed = 0;                ///< same request, same seed: same path
  const std::atomic<bool>* cancelled = nullptr;  ///< checked while planning
};

enum class PlanStatus {
  kSuccess,
  kInvalidRequest,
  kUnknownName,
  kStartInvalid,
  kGoalInvalid,
  kNoRoute,
  kTimeout,
  kCancelled
};

/// The constant's name in agrid_map/Status, e.g. "NO_ROUTE".
const char* toString(PlanStatus status);

struct Plan {
  PlanStatus status = PlanStatus::kSuccess;
  std::string message;               ///< why, for a person
  Route route;                       ///< areas and doors that the path really crosses
  std::vector<std::uint32_t> cells;  ///< cells that the path crosses, row-major indices, in order
  /// Corners of the path on a lattice of 1/32768 pixel; headings along it, the first and the last
  /// as asked. One pose where start and goal are the same. With a turning radius or a footprint:
  /// poses at most 2 pixels apart, each with the robot's heading; straight lines between them leave
  /// the robot's curve by at most 1/100 pixel.
  std::vector<Pose2> path_map;
  double length = 0;        ///< [m]
  double length_bound = 0;  ///< no path is shorter [m]
  /// Smallest distance from the path to an obstacle pixel's square [m]: exact up to 64 pixels,
  /// beyond it too small by at most 1.42; infinite without obstacles.
  double clearance = 0;
  bool start_moved = false;
  bool goal_moved = false;
  double planning_time = 0;  ///< [s]
};

/// The first level of a plan alone.
struct RouteList {
  PlanStatus status = PlanStatus::kSuccess;
  std::string message;        ///< why, for a person
  std::vector<Route> routes;  ///< shortest first, by straight lines from door to door
};

/// Plans on two levels, areas first, then the path through their cells. Exact with respect to the
/// metric map: every pixel that a returned path touches is free for the robot's radius, closed
/// doors are obstacles, and kNoRoute is returned only where the free pixels do not connect start
/// and goal (by their sides; diagonally where both pixels beside are free). The map's outermost
/// ring is never free, nor are forbidden areas (areaCost) but the start's. Safe with many threads.
class Planner {
 public:
  /// Prepares the parameters' radius; others are prepared when asked for, the last few are kept.
  /// @throws std::invalid_argument if a parameter is out of range or `map` is null
  Planner(std::shared_ptr<const SemanticMap> map, const PlannerParams& params);
  /// The same parameters for an edited map. Where the metric map and the closed doors are those of
  /// `former`, all that was prepared is shared, whatever areas, doors and objects are called; areas
  /// that were joined take the pieces of the former ones. `former` may be used, and may end,
  /// meanwhile.
  /// @throws std::invalid_argument if `map` is null
  Planner(std::shared_ptr<const SemanticMap> map, const Planner& former);
  ~Planner();

  Plan plan(const PlanRequest& request) const;

  /// Routes that differ in their doors; each of them can really be driven with the request's
  /// radius, and kSuccess is returned exactly where `plan` finds a path. An area without a name in
  /// the way, such as free space that belongs to no area, is left out of the routes.
  /// @param max_routes  at least 1; 0 is taken as 1
  RouteList routes(const PlanRequest& request, std::size_t max_routes) const;

  const PlannerParams& params() const;
  /// Of the circle for which the map is prepared: the parameters' radius, or with a footprint that
  /// of a circle so small that it is free wherever the footprint is [m].
  double circleRadius() const;

 private:
  friend struct planning::PlannerAccess;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace agrid
