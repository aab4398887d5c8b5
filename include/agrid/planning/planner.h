// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/topology/route.h"

namespace agrid {

/// Which pixels a robot's centre may be in.
enum class Clearance {
  kCostmap,  ///< centre farther than the radius from the nearest obstacle pixel's centre
             ///< (costmap_2d)
  kStrict    ///< no point of the pixel closer than the radius to an obstacle pixel's square
};

struct PlannerParams {
  double robot_radius = 0.2;  ///< [m]
  Clearance clearance = Clearance::kCostmap;
  bool allow_unknown = false;     ///< unknown space is no obstacle
  double timeout = 5;             ///< [s], at most 60
  std::string planner = "AGrid";  ///< or a geometric planner of OMPL such as RRTConnect
};

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
  double tolerance = 0;                ///< how far start and goal may be moved to free space [m]
  std::optional<double> robot_radius;  ///< [m]; none: the parameter
  std::optional<double> timeout;       ///< [s]; none: the parameter
  std::optional<std::string> planner;  ///< none: the parameter
  std::uint32_t seed = 0;
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
  Route route;                       ///< areas and doors that the path crosses
  std::vector<std::uint32_t> cells;  ///< cells that the path crosses, row-major indices, in order
  std::vector<Pose2> path_map;       ///< corners of the path; headings along it, the last as asked
  double length = 0;                 ///< [m]
  double length_bound = 0;           ///< no path is shorter [m]
  double clearance = 0;              ///< smallest distance to an obstacle along the path [m]
  bool start_moved = false;
  bool goal_moved = false;
  double planning_time = 0;  ///< [s]
};

/// Plans on two levels, areas first, then the path through their cells; exact with respect to the
/// metric map. Safe to use from several threads at once.
class Planner {
 public:
  /// @throws std::invalid_argument if a parameter is out of range
  Planner(std::shared_ptr<const SemanticMap> map, const PlannerParams& params);
  ~Planner();

  Plan plan(const PlanRequest& request) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace agrid
