// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "agrid/planning/planner.h"

namespace agrid {

// The library as seen from OMPL, for its users; the only public header that needs OMPL. States are
// in the map frame [m]. Spaces may be RealVectorStateSpace of two dimensions, SE2StateSpace,
// DubinsStateSpace, ReedsSheppStateSpace, and what `stateSpaceFor` returns; for any other,
// std::invalid_argument is thrown.

/// The space of a robot's motions: ReedsSheppStateSpace with a turning radius, a space of Dubins'
/// curves if it drives forwards alone, the plane for a circle that turns on the spot, and poses
/// between which it turns, drives and turns for a footprint. (OMPL 1.5's own DubinsStateSpace ends
/// the process in an assertion for some rare pairs of poses.)
ompl::base::StateSpacePtr stateSpaceFor(const PlannerParams& params);

/// Gives a space the bounds of the planner's map, and the planner's validity of states and motions
/// for its parameters' robot (circle or footprint): decided on the distance field along the whole
/// motion, no wall is too thin. In the plane it is exact: what Planner::plan returns is valid.
/// Elsewhere a motion that passes a pixel that is not free by less than 1/64 pixel is not valid.
/// The validity checker's clearance is the distance field's, beyond the robot's radius [m].
void useMap(const ompl::base::SpaceInformationPtr& space, std::shared_ptr<const Planner> planner);

/// Lets the samplers of a space draw most states near a path, such as that of Planner::plan, in
/// position and in heading, and one of five from everywhere; reproducibly.
/// @param lead_map  corners, at least one, map frame [m]
/// @param scale  how far states spread at most, such as the turning radius [m]
void guideSamplers(const ompl::base::SpaceInformationPtr& space, std::vector<Point2> lead_map,
                   double scale, std::uint32_t seed);

/// Path length that counts more where obstacles are near: 1 + `weight` at an obstacle, falling
/// evenly to 1 where the validity checker's clearance reaches `comfort` [m].
class ClearanceObjective : public ompl::base::StateCostIntegralObjective {
 public:
  /// @throws std::invalid_argument if `comfort` is not positive or `weight` is negative
  ClearanceObjective(const ompl::base::SpaceInformationPtr& space, double comfort, double weight);
  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCostHeuristic(const ompl::base::State* a,
                                       const ompl::base::State* b) const override;

 private:
  double comfort_;
  double weight_;
};

/// The package's planner for OMPL. A path for a circle that turns on the spot leads; in the plane
/// it is the answer, elsewhere a roadmap along it is searched until it holds a path, which is then
/// shortened. States and motions are those that the space information finds valid, so it can be
/// stricter than the map. The same problem and seed give the same path.
class AGridPlanner : public ompl::base::Planner {
 public:
  /// @param planner  its map and its parameters' robot; not null
  AGridPlanner(const ompl::base::SpaceInformationPtr& space,
               std::shared_ptr<const agrid::Planner> planner);
  /// With a planner of its own. @throws std::invalid_argument as agrid::Planner does
  AGridPlanner(const ompl::base::SpaceInformationPtr& space, std::shared_ptr<const SemanticMap> map,
               const PlannerParams& params);
  ~AGridPlanner() override;

  /// @return EXACT_SOLUTION, INVALID_START, INVALID_GOAL, UNRECOGNIZED_GOAL_TYPE (states of the
  ///         goal can't be drawn) or TIMEOUT. Where the map does not connect start and goal, which
  ///         is answered at once: INFEASIBLE, or before OMPL 1.6, which lacks that, TIMEOUT with a
  ///         proof (ProblemDefinition::hasSolutionNonExistenceProof). The condition is asked before
  ///         and after the lead, which takes milliseconds, and then at each motion.
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// Also OMPL's planner parameter `seed`.
  void setSeed(unsigned seed);
  unsigned getSeed() const;

 private:
  struct Impl;
  ompl::base::PlannerStatus solveAlong(const ompl::base::PlannerTerminationCondition& stop);
  ompl::base::PlannerStatus refuse(PlanStatus status);

  std::unique_ptr<Impl> impl_;
};

}  // namespace agrid
