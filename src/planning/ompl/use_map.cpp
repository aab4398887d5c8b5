// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "agrid/planning/ompl_planner.h"
#include "planning/ompl/exact_space.h"
#include "planning/ompl/lead_path.h"
#include "planning/ompl/map_space.h"
#include "planning/ompl/turning_path.h"
#include "planning/planner_access.h"

namespace agrid {
namespace {

namespace ob = ompl::base;

constexpr double kPi = 3.14159265358979323846;
constexpr double kUnguidedShare = 0.2;

class LeadSampler : public ob::StateSampler {
 public:
  LeadSampler(const ob::StateSpace* space, const planning::SpaceMotions& motions,
              std::shared_ptr<const planning::LeadPath> lead, double scale, std::uint32_t seed)
      : ob::StateSampler(space),
        motions_(motions),
        lead_(std::move(lead)),
        samples_(*lead_, scale, seed) {}

  void sampleUniform(ob::State* state) override {
    ompl::RNG& random = samples_.random();
    Pose2 pose = samples_.any();
    if (random.uniform01() < kUnguidedShare) {
      const ob::RealVectorBounds& box = motions_.bounds();
      pose.position.x() = random.uniformReal(box.low[0], box.high[0]);
      pose.position.y() = random.uniformReal(box.low[1], box.high[1]);
      pose.yaw = random.uniformReal(-kPi, kPi);
    }
    set(state, pose);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    ompl::RNG& random = samples_.random();
    Pose2 pose = motions_.pose(near);
    for (int i = 0; i < 2; ++i) pose.position[i] += random.uniformReal(-distance, distance);
    pose.yaw += random.uniformReal(-distance, distance);
    set(state, pose);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    ompl::RNG& random = samples_.random();
    Pose2 pose = motions_.pose(mean);
    for (int i = 0; i < 2; ++i) pose.position[i] += random.gaussian(0, deviation);
    pose.yaw += random.gaussian(0, deviation);
    set(state, pose);
  }

 private:
  void set(ob::State* state, const Pose2& pose) {
    motions_.set(state, pose);
    space_->enforceBounds(state);
  }

  planning::SpaceMotions motions_;
  std::shared_ptr<const planning::LeadPath> lead_;
  planning::LeadSamples samples_;
};

}  // namespace

ob::StateSpacePtr stateSpaceFor(const PlannerParams& params) {
  if (params.turning_radius == 0 && params.footprint.empty()) {
    return std::make_shared<ob::RealVectorStateSpace>(2);
  }
  return planning::curveSpace(params.turning_radius, params.motion);
}

void useMap(const ob::SpaceInformationPtr& space, std::shared_ptr<const Planner> planner) {
  if (!planner) throw std::invalid_argument("useMap: the planner is null");
  planning::silenceOmpl();
  const auto robot = planning::PlannerAccess::core(*planner).robot(planner->circleRadius(),
                                                                   planner->params().footprint, {});
  // The robot knows the planner's obstacles: one lives as long as the other.
  const auto both = std::make_shared<
      const std::pair<std::shared_ptr<const Planner>, std::shared_ptr<const planning::SweptRobot>>>(
      std::move(planner), robot);
  planning::placeInMap(space, {both, both->second.get()});
}

void guideSamplers(const ob::SpaceInformationPtr& space, std::vector<Point2> lead_map, double scale,
                   std::uint32_t seed) {
  if (lead_map.empty()) throw std::invalid_argument("guideSamplers: the lead has no corner");
  const auto lead = std::make_shared<const planning::LeadPath>(std::move(lead_map));
  // The allocator is the space's own, so it must not keep the space alive.
  const std::weak_ptr<ob::StateSpace> weak = space->getStateSpace();
  auto next_seed = std::make_shared<std::uint32_t>(seed);
  space->getStateSpace()->setStateSamplerAllocator(
      [=](const ob::StateSpace* states) -> ob::StateSamplerPtr {
        *next_seed = *next_seed * 1664525U + 1013904223U;
        const planning::SpaceMotions motions(weak.lock());
        return std::make_shared<LeadSampler>(states, motions, lead, scale, *next_seed);
      });
}

ClearanceObjective::ClearanceObjective(const ob::SpaceInformationPtr& space, double comfort,
                                       double weight)
    : ob::StateCostIntegralObjective(space, true), comfort_(comfort), weight_(weight) {
  description_ = "length, counted more near obstacles";
  if (!(comfort > 0)) throw std::invalid_argument("ClearanceObjective: comfort must be positive");
  if (!(weight >= 0)) throw std::invalid_argument("ClearanceObjective: weight must be at least 0");
}

ob::Cost ClearanceObjective::stateCost(const ob::State* state) const {
  const double clearance = si_->getStateValidityChecker()->clearance(state);
  return ob::Cost(1 + weight_ * (1 - std::clamp(clearance / comfort_, 0.0, 1.0)));
}

ob::Cost ClearanceObjective::motionCostHeuristic(const ob::State* a, const ob::State* b) const {
  return ob::Cost(si_->distance(a, b));
}

}  // namespace agrid
