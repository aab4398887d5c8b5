// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/ompl_planner.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <ompl/base/SolutionNonExistenceProof.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>

#include "planning/ompl/lead_roadmap.h"
#include "planning/planner_access.h"
#include "planning/request_check.h"

namespace agrid {
namespace {

namespace ob = ompl::base;

/// Further starts and goals of a problem are left out.
constexpr std::size_t kMaxEnds = 8;
constexpr int kNoLimit = std::numeric_limits<int>::max();

std::shared_ptr<const agrid::Planner> requirePlanner(
    std::shared_ptr<const agrid::Planner> planner) {
  if (!planner) throw std::invalid_argument("AGridPlanner: the planner is null");
  return planner;
}

std::vector<Point2> pointsOf(const Plan& plan) {
  std::vector<Point2> points;
  for (const Pose2& pose : plan.path_map) points.push_back(pose.position);
  return points;
}

/// States that are freed at the end.
class States {
 public:
  explicit States(ob::SpaceInformationPtr space) : space_(std::move(space)) {}
  ~States() { clear(); }
  States(const States&) = delete;
  States& operator=(const States&) = delete;

  void addCopy(const ob::State* state) { list.push_back(space_->cloneState(state)); }
  void clear() {
    for (ob::State* state : list) space_->freeState(state);
    list.clear();
  }
  std::vector<ob::State*> list;

 private:
  ob::SpaceInformationPtr space_;
};

}  // namespace

struct AGridPlanner::Impl {
  Impl(const ob::SpaceInformationPtr& si, std::shared_ptr<const agrid::Planner> own)
      : space(si), motions(si->getStateSpace()), planner(std::move(own)), starts(si), goals(si) {}

  /// The lead between two states; for a robot with a footprint that of a circle inside.
  Plan leadOf(const ob::State* start, const ob::State* goal) const {
    PlanRequest request;
    request.start.position_map = motions.pose(start).position;
    PlanPoint end;
    end.position_map = motions.pose(goal).position;
    request.goal = end;
    request.robot_radius = planner->circleRadius();
    request.turning_radius = 0;
    request.timeout = planning::kMaxTimeout;
    request.planner = planning::kOwnPlanner;
    request.seed = seed;
    return planner->plan(request);
  }

  struct Ends {
    const ob::State* start = nullptr;
    const ob::State* goal = nullptr;
    Plan lead;
  };
  /// The start and the goal that are nearest to each other, by their lead.
  Ends choose(const ob::PlannerTerminationCondition& stop) const {
    Ends best;
    best.lead.status = PlanStatus::kTimeout;
    for (const ob::State* start : starts.list) {
      for (const ob::State* goal : goals.list) {
        if (stop) return best;
        Plan lead = leadOf(start, goal);
        const bool found = lead.status == PlanStatus::kSuccess;
        const bool had = best.lead.status == PlanStatus::kSuccess;
        if (best.start != nullptr && (!found || (had && lead.length >= best.lead.length))) continue;
        best = {start, goal, std::move(lead)};
      }
    }
    return best;
  }

  /// The lead itself, if it is a path in this space.
  bool takeLead(const Ends& ends, States& path) const {
    if (!motions.isPlane()) return false;
    const std::vector<Point2> corners = pointsOf(ends.lead);
    ob::State* corner = space->allocState();
    path.addCopy(ends.start);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      motions.set(corner, {corners[i], 0});
      path.addCopy(corner);
    }
    path.addCopy(ends.goal);
    space->freeState(corner);
    bool valid = true;
    for (std::size_t i = 1; i < path.list.size() && valid; ++i) {
      valid = space->checkMotion(path.list[i - 1], path.list[i]);
    }
    if (!valid) path.clear();
    return valid;
  }

  const MapGeometry& geometry() const {
    return planning::PlannerAccess::core(*planner).map().map().geometry();
  }
  double scale() const {
    if (motions.turningRadius() > 0) return motions.turningRadius();
    return std::max(planner->circleRadius(), 4 * geometry().resolution);
  }

  ob::SpaceInformationPtr space;
  planning::SpaceMotions motions;
  std::shared_ptr<const agrid::Planner> planner;
  States starts;
  States goals;
  std::unique_ptr<planning::LeadRoadmap> roadmap;
  unsigned seed = 0;
};

AGridPlanner::AGridPlanner(const ob::SpaceInformationPtr& space,
                           std::shared_ptr<const agrid::Planner> planner)
    : ob::Planner(space, "AGrid"),
      impl_(std::make_unique<Impl>(space, requirePlanner(std::move(planner)))) {
  specs_.directed = true;
  declareParam<unsigned>("seed", this, &AGridPlanner::setSeed, &AGridPlanner::getSeed);
}

AGridPlanner::AGridPlanner(const ob::SpaceInformationPtr& space,
                           std::shared_ptr<const SemanticMap> map, const PlannerParams& params)
    : AGridPlanner(space, std::make_shared<const agrid::Planner>(std::move(map), params)) {}

AGridPlanner::~AGridPlanner() = default;

void AGridPlanner::setSeed(unsigned seed) { impl_->seed = seed; }
unsigned AGridPlanner::getSeed() const { return impl_->seed; }

void AGridPlanner::clear() {
  ob::Planner::clear();
  impl_->starts.clear();
  impl_->goals.clear();
  impl_->roadmap.reset();
}

void AGridPlanner::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  if (impl_->roadmap) impl_->roadmap->getData(data);
}

ob::PlannerStatus AGridPlanner::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  if (stop) return ob::PlannerStatus::TIMEOUT;
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  while (impl_->starts.list.size() < kMaxEnds) {
    const ob::State* state = pis_.nextStart();
    if (state == nullptr) break;
    impl_->starts.addCopy(state);
  }
  if (impl_->starts.list.empty()) return ob::PlannerStatus::INVALID_START;
  // Where goals are still being drawn by another thread, the first one is worth waiting for.
  const bool lazy = dynamic_cast<const ob::GoalLazySamples*>(goal) != nullptr;
  while (impl_->goals.list.size() < kMaxEnds) {
    const bool wait = lazy && impl_->goals.list.empty();
    const ob::State* state = wait ? pis_.nextGoal(stop) : pis_.nextGoal();
    if (state == nullptr) break;
    impl_->goals.addCopy(state);
  }
  if (impl_->goals.list.empty()) return ob::PlannerStatus::INVALID_GOAL;
  return solveAlong(stop);
}

ob::PlannerStatus AGridPlanner::refuse(PlanStatus status) {
  switch (status) {
    case PlanStatus::kStartInvalid:
      return ob::PlannerStatus::INVALID_START;
    case PlanStatus::kGoalInvalid:
      return ob::PlannerStatus::INVALID_GOAL;
    case PlanStatus::kNoRoute:
      pdef_->setSolutionNonExistenceProof(
          std::make_shared<ob::SolutionNonExistenceProof>(impl_->space));
#if OMPL_VERSION_VALUE >= 1006000
      return ob::PlannerStatus::INFEASIBLE;
#else
      return ob::PlannerStatus::TIMEOUT;
#endif
    default:
      return ob::PlannerStatus::TIMEOUT;
  }
}

ob::PlannerStatus AGridPlanner::solveAlong(const ob::PlannerTerminationCondition& stop) {
  States path(impl_->space);
  if (!impl_->roadmap) {
    const Impl::Ends ends = impl_->choose(stop);
    if (ends.lead.status != PlanStatus::kSuccess) return refuse(ends.lead.status);
    if (!impl_->takeLead(ends, path)) {
      impl_->roadmap = std::make_unique<planning::LeadRoadmap>(
          impl_->space, planning::LeadPath(pointsOf(ends.lead)), impl_->scale(), impl_->seed);
      impl_->roadmap->addStart(ends.start);
      impl_->roadmap->addGoal(ends.goal);
    }
  }
  if (path.list.empty()) {
    for (const ob::State* state : impl_->roadmap->solve(stop, kNoLimit)) path.addCopy(state);
    if (path.list.empty()) return ob::PlannerStatus::TIMEOUT;
    planning::shortenAlong(impl_->space, impl_->seed + 1, stop, path.list);
  }
  auto solution = std::make_shared<ompl::geometric::PathGeometric>(impl_->space);
  for (const ob::State* state : path.list) solution->append(state);
  pdef_->addSolutionPath(solution, false, 0, getName());
  return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace agrid
