// SPDX-License-Identifier: BSD-3-Clause
#include "planning/request_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "planning/ompl/planner_by_name.h"

namespace agrid {
namespace {

const char* const kOwnPlanner = "AGrid";

}  // namespace

std::vector<std::string> plannerNames() {
  std::vector<std::string> names = planning::omplPlannerNames();
  names.push_back(kOwnPlanner);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace agrid

namespace agrid::planning {
namespace {

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
  void requireTurningOnTheSpot(double value) {
    requireAtLeastZero("turning_radius", value);
    if (value > 0) add("turning_radius", value, "only 0, turning on the spot, can be planned for");
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

Query checkedQuery(const PlanRequest& request, const PlannerParams& params) {
  Query query{request.robot_radius.value_or(params.robot_radius),
              request.timeout.value_or(params.timeout),
              request.planner.value_or(params.planner),
              {}};
  Problems problems;
  problems.requireAtLeastZero("robot_radius", query.robot_radius);
  problems.requireAtLeastZero("tolerance", request.tolerance);
  problems.requireTimeout(query.timeout);
  problems.requireTurningOnTheSpot(request.turning_radius.value_or(params.turning_radius));
  problems.requirePlanner(query.planner);
  problems.requireYaw("start.yaw", request.start);
  if (const auto* goal = std::get_if<PlanPoint>(&request.goal)) {
    problems.requireYaw("goal.yaw", *goal);
  }
  query.problem = problems.text();
  return query;
}

void requireValid(const PlannerParams& params) {
  const std::string problem = checkedQuery(PlanRequest{}, params).problem;
  if (!problem.empty()) throw std::invalid_argument("PlannerParams: " + problem);
}

}  // namespace agrid::planning
