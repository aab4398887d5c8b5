// SPDX-License-Identifier: BSD-3-Clause
#include "planning/request_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "planning/ompl/footprint.h"
#include "planning/ompl/planner_by_name.h"

namespace agrid {

std::vector<std::string> plannerNames() {
  std::vector<std::string> names = planning::omplPlannerNames();
  names.push_back(planning::kOwnPlanner);
  std::sort(names.begin(), names.end());
  return names;
}

std::string problemOf(const PlannerParams& params) {
  return planning::checkedQuery(PlanRequest{}, params, 0).problem;
}

}  // namespace agrid

namespace agrid::planning {
namespace {

/// A circle that is free wherever the outline is, so that its component check never wrongs the
/// outline: smaller than the circle inside by what the rule of clearance measures too little. The
/// pixel of a point that is farther than r from an obstacle's square has its centre farther than
/// r - (sqrt(2) - 1) / 2 pixels from the obstacle's centre, its square r - sqrt(2) from the other.
double leadingRadius(const PlannerParams& params, double resolution) {
  const double slack_px = params.clearance == Clearance::kStrict ? 1.4143 : 0.2072;
  return std::max(0.0, Footprint(params.footprint).innerRadius() - slack_px * resolution);
}

/// Collects what is wrong with some values.
class Problems {
 public:
  void requireAtLeastZero(const std::string& field, double value) {
    if (value >= 0 && std::isfinite(value)) return;
    add(field, value, "must be at least 0 and finite");
  }
  void requireTimeout(double value) {
    if (value > 0 && value <= kMaxTimeout) return;
    add("timeout", value, "must lie in (0, 60] s");
  }
  void requireFootprint(const Polygon& footprint) {
    if (footprint.empty()) return;
    const std::string problem = footprintProblem(footprint);
    if (problem.empty()) return;
    separate();
    text_ << problem;
  }
  void requireNoTurns(const Query& query) {
    if (!query.turns() || query.planner == kOwnPlanner) return;
    separate();
    text_ << "planner '" << query.planner << "' plans for a circle that turns on the spot; "
          << "turning_radius and footprint need '" << kOwnPlanner << "'";
  }
  void requirePlanner(const std::string& name) {
    if (name == kOwnPlanner || isOmplPlanner(name)) return;
    separate();
    text_ << "planner '" << name << "' is unknown; there are:";
    for (const std::string& known : plannerNames()) text_ << ' ' << known;
  }
  void requireYaw(const std::string& field, const PlanPoint& point) {
    if (point.yaw && !std::isfinite(*point.yaw)) add(field, *point.yaw, "must be finite");
  }
  std::string text() const { return text_.str(); }

 private:
  void separate() {
    if (text_.tellp() > 0) text_ << "; ";
  }
  void add(const std::string& field, double value, const std::string& bound) {
    separate();
    text_ << field << ' ' << value << ": " << bound;
  }
  std::ostringstream text_;
};

}  // namespace

Query checkedQuery(const PlanRequest& request, const PlannerParams& params, double resolution) {
  Query query;
  query.robot_radius = request.robot_radius.value_or(params.robot_radius);
  query.timeout = request.timeout.value_or(params.timeout);
  query.planner = request.planner.value_or(params.planner);
  query.turning_radius = request.turning_radius.value_or(params.turning_radius);
  query.motion = params.motion;
  Problems problems;
  problems.requireAtLeastZero("robot_radius", query.robot_radius);
  problems.requireAtLeastZero("tolerance", request.tolerance);
  problems.requireTimeout(query.timeout);
  problems.requireAtLeastZero("turning_radius", query.turning_radius);
  problems.requireFootprint(params.footprint);
  problems.requirePlanner(query.planner);
  problems.requireYaw("start.yaw", request.start);
  if (const auto* goal = std::get_if<PlanPoint>(&request.goal)) {
    problems.requireYaw("goal.yaw", *goal);
  }
  query.problem = problems.text();
  // A request that names a radius asks for a circle.
  if (query.problem.empty() && !params.footprint.empty() && !request.robot_radius) {
    query.footprint = params.footprint;
    query.robot_radius = leadingRadius(params, resolution);
  }
  problems.requireNoTurns(query);
  query.problem = problems.text();
  return query;
}

void requireValid(const PlannerParams& params) {
  const std::string problem = problemOf(params);
  if (!problem.empty()) throw std::invalid_argument("PlannerParams: " + problem);
}

}  // namespace agrid::planning
