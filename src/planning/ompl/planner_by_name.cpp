// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/planner_by_name.h"

#include <functional>
#include <map>
#include <memory>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include "planning/ompl/exact_space.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// OMPL seeds its generators one after the other for the whole process; this one's own generator
/// depends on the request alone.
template <typename Planner>
class Seeded : public Planner {
 public:
  Seeded(const ob::SpaceInformationPtr& space, std::uint32_t seed) : Planner(space) {
    this->rng_.setLocalSeed(seed);
  }
};

struct Factory {
  std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&, std::uint32_t)> make;
  bool improves = false;  ///< goes on after its first path
};

template <typename Planner>
Factory seeded(bool improves = false) {
  return {[](const ob::SpaceInformationPtr& space, std::uint32_t seed) -> ob::PlannerPtr {
            return std::make_shared<Seeded<Planner>>(space, seed);
          },
          improves};
}

/// For planners whose randomness comes from the samplers alone, or from generators that OMPL keeps
/// to itself.
template <typename Planner>
Factory plain(bool improves = false) {
  return {[](const ob::SpaceInformationPtr& space, std::uint32_t) -> ob::PlannerPtr {
            return std::make_shared<Planner>(space);
          },
          improves};
}

const std::map<std::string, Factory>& factories() {
  static const std::map<std::string, Factory> kFactories{
      {"ABITstar", plain<og::ABITstar>(true)},
      {"AITstar", plain<og::AITstar>(true)},
      {"BFMT", plain<og::BFMT>()},
      {"BITstar", plain<og::BITstar>(true)},
      {"BKPIECE1", seeded<og::BKPIECE1>()},
      {"BiEST", seeded<og::BiEST>()},
      {"BiTRRT", plain<og::BiTRRT>()},
      {"EST", seeded<og::EST>()},
      {"FMT", plain<og::FMT>()},
      {"InformedRRTstar", seeded<og::InformedRRTstar>(true)},
      {"KPIECE1", seeded<og::KPIECE1>()},
      {"LBKPIECE1", seeded<og::LBKPIECE1>()},
      {"LBTRRT", seeded<og::LBTRRT>(true)},
      {"LazyPRM", plain<og::LazyPRM>()},
      {"LazyPRMstar", plain<og::LazyPRMstar>(true)},
      {"LazyRRT", seeded<og::LazyRRT>()},
      {"PDST", seeded<og::PDST>()},
      {"PRM", seeded<og::PRM>()},
      {"PRMstar", seeded<og::PRMstar>(true)},
      {"ProjEST", seeded<og::ProjEST>()},
      {"RRT", seeded<og::RRT>()},
      {"RRTConnect", seeded<og::RRTConnect>()},
      {"RRTXstatic", seeded<og::RRTXstatic>(true)},
      {"RRTsharp", seeded<og::RRTsharp>(true)},
      {"RRTstar", seeded<og::RRTstar>(true)},
      {"SBL", seeded<og::SBL>()},
      {"SORRTstar", seeded<og::SORRTstar>(true)},
      {"SPARS", seeded<og::SPARS>()},
      {"SPARStwo", seeded<og::SPARStwo>()},
      {"STRIDE", seeded<og::STRIDE>()},
      {"TRRT", seeded<og::TRRT>()}};
  return kFactories;
}

/// Path length; informed planners reject samples of the space's own sampler, which is guided and
/// seeded, instead of drawing from an ellipse with a generator of their own.
class GuidedPathLength : public ob::PathLengthOptimizationObjective {
 public:
  using ob::PathLengthOptimizationObjective::PathLengthOptimizationObjective;
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned max_calls) const override {
    return std::make_shared<ob::RejectionInfSampler>(problem, max_calls);
  }
};

ob::ProblemDefinitionPtr problemOf(const ob::SpaceInformationPtr& space, const OmplQuery& query,
                                   bool improves) {
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<> start(space);
  ob::ScopedState<> goal(space);
  setState(start.get(), query.start);
  setState(goal.get(), query.goal);
  problem->setStartAndGoalStates(start, goal, 1e-6);
  if (improves) {
    auto objective = std::make_shared<GuidedPathLength>(space);
    objective->setCostThreshold(ob::Cost(query.good_length_px));
    problem->setOptimizationObjective(objective);
  }
  return problem;
}

}  // namespace

std::vector<std::string> omplPlannerNames() {
  std::vector<std::string> names;
  for (const auto& entry : factories()) names.push_back(entry.first);
  return names;
}

bool isOmplPlanner(const std::string& name) { return factories().count(name) > 0; }

std::vector<FinePoint> planByOmpl(const FreeSpace& free, const OmplQuery& query,
                                  const StopCheck& stop) {
  const Factory& factory = factories().at(query.planner);
  const auto space = exactSpace(free);
  guideSamplers(space, query.lead, query.seed);
  const auto problem = problemOf(space, query, factory.improves);
  const ob::PlannerPtr planner = factory.make(space, query.seed + 1);
  planner->setProblemDefinition(problem);
  planner->setup();
  const ob::PlannerStatus status = planner->solve(
      ob::PlannerTerminationCondition([&stop] { return stop.isLate() || stop.isCancelled(); }));
  if (stop.isCancelled()) throw Stopped{PlanStatus::kCancelled};
  std::vector<FinePoint> corners;
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return corners;
  const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
  if (!path || !path->check()) return corners;
  for (const ob::State* state : path->getStates()) corners.push_back(finePointOf(state));
  return corners;
}

}  // namespace agrid::planning
