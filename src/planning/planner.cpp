// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/planner.h"

#include <algorithm>
#include <utility>

#include "planning/area_routes.h"
#include "planning/ompl/exact_space.h"
#include "planning/planner_access.h"
#include "planning/planner_core.h"

namespace agrid {
namespace {

using Clock = std::chrono::steady_clock;

const PlannerParams& valid(const PlannerParams& params) {
  planning::requireValid(params);
  return params;
}

std::string stoppedMessage(PlanStatus status, double timeout) {
  if (status == PlanStatus::kCancelled) return "cancelled";
  return "no answer within " + std::to_string(timeout) + " s";
}

planning::StopCheck stopOf(const PlanRequest& request, const planning::Query& query,
                           Clock::time_point begin) {
  const auto time =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(query.timeout));
  return {begin + time, request.cancelled};
}

/// Runs the steps of an answer; what ends it early becomes its status.
template <typename Answer, typename Steps>
Answer answer(const PlanRequest& request, const PlannerParams& params, const SemanticMap& map,
              const Steps& steps) {
  const auto begin = Clock::now();
  Answer refused;
  const double resolution = map.map().geometry().resolution;
  const planning::Query query = planning::checkedQuery(request, params, resolution);
  refused.status = PlanStatus::kInvalidRequest;
  refused.message = query.problem;
  if (!query.problem.empty()) return refused;
  try {
    return steps(query, stopOf(request, query, begin));
  } catch (const planning::Refusal& refusal) {
    refused.status = refusal.status;
    refused.message = refusal.message;
  } catch (const planning::Stopped& stopped) {
    refused.status = stopped.status;
    refused.message = stoppedMessage(stopped.status, query.timeout);
  }
  return refused;
}

}  // namespace

const char* toString(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSuccess:
      return "SUCCESS";
    case PlanStatus::kInvalidRequest:
      return "INVALID_REQUEST";
    case PlanStatus::kUnknownName:
      return "UNKNOWN_NAME";
    case PlanStatus::kStartInvalid:
      return "START_INVALID";
    case PlanStatus::kGoalInvalid:
      return "GOAL_INVALID";
    case PlanStatus::kNoRoute:
      return "NO_ROUTE";
    case PlanStatus::kTimeout:
      return "TIMEOUT";
    case PlanStatus::kCancelled:
      return "CANCELLED";
  }
  return "INVALID_REQUEST";
}

namespace {

double circleRadiusOf(const SemanticMap& map, const PlannerParams& params) {
  return planning::checkedQuery({}, params, map.map().geometry().resolution).robot_radius;
}

/// The same for the circle that leads a robot with a footprint.
PlannerParams ofCircle(const std::shared_ptr<const SemanticMap>& map, const PlannerParams& params) {
  PlannerParams result = params;
  if (map) result.robot_radius = circleRadiusOf(*map, params);
  return result;
}

}  // namespace

struct Planner::Impl {
  Impl(const std::shared_ptr<const SemanticMap>& map, const Impl& former)
      : params(former.params), core(map, ofCircle(map, former.params), former.core) {}
  Impl(const std::shared_ptr<const SemanticMap>& map, const PlannerParams& planner_params)
      : params(valid(planner_params)), core(map, ofCircle(map, planner_params)) {
    planning::silenceOmpl();
  }
  PlannerParams params;
  planning::PlannerCore core;
};

Planner::Planner(std::shared_ptr<const SemanticMap> map, const PlannerParams& params)
    : impl_(std::make_unique<Impl>(map, params)) {}

Planner::Planner(std::shared_ptr<const SemanticMap> map, const Planner& former)
    : impl_(std::make_unique<Impl>(map, *former.impl_)) {}

Planner::~Planner() = default;

const PlannerParams& Planner::params() const { return impl_->params; }

double Planner::circleRadius() const { return circleRadiusOf(impl_->core.map(), impl_->params); }

Plan Planner::plan(const PlanRequest& request) const {
  const auto begin = Clock::now();
  const planning::PlannerCore& core = impl_->core;
  Plan plan = answer<Plan>(request, impl_->params, core.map(),
                           [&](const planning::Query& query, const planning::StopCheck& stop) {
                             const planning::Task task = core.taskOf(request, query, stop);
                             auto path = core.pathOf(task, query, request.seed, stop);
                             if (query.turns())
                               path = core.turningPathOf(task, request, query, path, stop);
                             return core.planOf(task, request, path);
                           });
  plan.planning_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return plan;
}

RouteList Planner::routes(const PlanRequest& request, std::size_t max_routes) const {
  const planning::PlannerCore& core = impl_->core;
  return answer<RouteList>(
      request, impl_->params, core.map(),
      [&](const planning::Query& query, const planning::StopCheck& stop) {
        const planning::Task task = core.taskOf(request, query, stop);
        const planning::AreaRoutes area_routes(core.map(), task.level->areas(stop));
        RouteList list;
        list.routes = area_routes.find(task.start.point, task.target,
                                       std::max<std::size_t>(max_routes, 1), stop);
        return list;
      });
}

const planning::PlannerCore& planning::PlannerAccess::core(const Planner& planner) {
  return planner.impl_->core;
}

}  // namespace agrid
