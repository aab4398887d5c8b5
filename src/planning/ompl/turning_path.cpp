// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/turning_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include "planning/ompl/forward_space.h"
#include "planning/ompl/lead_roadmap.h"
#include "planning/ompl/map_space.h"
#include "planning/ompl/turn_drive_space.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;

constexpr double kPi = 3.14159265358979323846;
constexpr double kStepPx = 2;
constexpr double kMaxSagittaPx = 0.01;
constexpr double kMaxTurn = 0.2;  ///< between two poses on the spot [rad]
/// How often the roadmap along the first lead grows before another lead is asked for.
constexpr int kFirstRounds = 4;
/// Turning by one radian on the spot counts as so many metres.
constexpr double kTurnCost = 0.1;

/// The heading that is asked for, or some to choose from.
std::vector<double> headings(const std::optional<double>& asked, double along) {
  if (asked) return {*asked};
  std::vector<double> yaws{along};
  for (const double turned : {0.15, 0.3, 0.5, 0.8, 1.2, kPi / 2, 2.2}) {
    yaws.push_back(along + turned);
    yaws.push_back(along - turned);
  }
  yaws.push_back(along + kPi);
  return yaws;
}

int stepsOf(const MotionPiece& piece, double resolution) {
  double step = kStepPx;
  if (piece.curvature() > 0) {
    const double radius_px = 1 / (piece.curvature() * resolution);
    step = std::min(step, std::sqrt(8 * radius_px * kMaxSagittaPx));
  }
  const double ways = std::abs(piece.length) / resolution / step;
  const double turns = piece.length == 0 ? std::abs(piece.turn) / kMaxTurn : 0;
  return std::max(1, static_cast<int>(std::ceil(std::max(ways, turns) - 1e-9)));
}

class TurningPlan {
 public:
  TurningPlan(const std::shared_ptr<const SweptRobot>& robot, const TurningQuery& query)
      : query_(query),
        space_(
            std::make_shared<ob::SpaceInformation>(curveSpace(query.turning_radius, query.motion))),
        resolution_(robot->free().geometry().resolution) {
    placeInMap(space_, robot);
    space_->setup();
    scale_ = query.turning_radius > 0 ? query.turning_radius
                                      : std::max(robot->outerRadius(), 4 * resolution_);
  }
  ~TurningPlan() {
    for (ob::State* state : path_) space_->freeState(state);
  }
  TurningPlan(const TurningPlan&) = delete;
  TurningPlan& operator=(const TurningPlan&) = delete;

  void run(const ob::PlannerTerminationCondition& stop) {
    std::vector<std::unique_ptr<LeadRoadmap>> roadmaps;
    roadmaps.push_back(roadmapAlong(query_.lead_map));
    for (int rounds = kFirstRounds; path_.empty() && !stop; rounds *= 2) {
      for (const auto& roadmap : roadmaps) {
        const auto states = roadmap->solve(stop, rounds);
        for (const ob::State* state : states) path_.push_back(space_->cloneState(state));
        if (!path_.empty()) break;
      }
      if (!path_.empty() || rounds > kFirstRounds || !query_.detour_map) continue;
      const std::vector<Point2> detour = query_.detour_map();
      if (!detour.empty()) roadmaps.push_back(roadmapAlong(detour));
    }
    shortenAlong(space_, query_.seed + 1, stop, path_);
  }

  std::vector<Pose2> poses() const {
    std::vector<Pose2> poses;
    if (path_.empty()) return poses;
    const SpaceMotions motions(space_->getStateSpace());
    poses.push_back(motions.pose(path_.front()));
    for (std::size_t i = 1; i < path_.size(); ++i) {
      for (const MotionPiece& piece : motions.between(path_[i - 1], path_[i])) {
        const int steps = stepsOf(piece, resolution_);
        for (int k = 1; k <= steps; ++k) poses.push_back(piece.at(double(k) / steps));
      }
    }
    return poses;
  }

 private:
  std::unique_ptr<LeadRoadmap> roadmapAlong(const std::vector<Point2>& corners) const {
    const LeadPath lead(corners);
    auto roadmap = std::make_unique<LeadRoadmap>(space_, lead, scale_, query_.seed);
    const double all = lead.length();
    for (const auto& state : states(lead.at(0), query_.start_yaw, lead.heading(0, 0, scale_))) {
      roadmap->addStart(state.get());
    }
    for (const auto& state : states(lead.at(all), query_.goal_yaw, lead.heading(all, scale_, 0))) {
      roadmap->addGoal(state.get());
    }
    return roadmap;
  }
  std::vector<ob::ScopedState<>> states(const Point2& position, const std::optional<double>& asked,
                                        double along) const {
    const SpaceMotions motions(space_->getStateSpace());
    std::vector<ob::ScopedState<>> states;
    for (const double yaw : headings(asked, along)) {
      ob::ScopedState<> state(space_);
      motions.set(state.get(), {position, yaw});
      if (space_->isValid(state.get())) states.push_back(state);
    }
    return states;
  }

  const TurningQuery& query_;
  ob::SpaceInformationPtr space_;
  double resolution_;
  double scale_ = 0;
  std::vector<ob::State*> path_;
};

}  // namespace

ob::StateSpacePtr curveSpace(double turning_radius, Motion motion) {
  const bool backwards = motion == Motion::kReedsShepp;
  if (turning_radius == 0) return std::make_shared<TurnDriveSpace>(backwards, kTurnCost);
  if (!backwards) return std::make_shared<ForwardSpace>(turning_radius);
  return std::make_shared<ob::ReedsSheppStateSpace>(turning_radius);
}

std::vector<Pose2> planTurning(const std::shared_ptr<const SweptRobot>& robot,
                               const TurningQuery& query, const StopCheck& stop) {
  TurningPlan plan(robot, query);
  plan.run(
      ob::PlannerTerminationCondition([&stop] { return stop.isCancelled() || stop.isLate(); }));
  if (stop.isCancelled()) throw Stopped{PlanStatus::kCancelled};
  return plan.poses();
}

}  // namespace agrid::planning
