// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/ompl_planner.h"

#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using test::Scene;

/// Two rooms, a passage at the bottom, and a room without one.
Scene rooms() {
  std::vector<std::string> rows(40, "#" + std::string(58, '.') + "#");
  rows.front() = rows.back() = std::string(60, '#');
  for (std::size_t y = 0; y < 30; ++y) rows[y].replace(20, 2, "##");
  for (auto& row : rows) row.replace(45, 2, "##");
  Scene scene = test::sceneOf(rows, 0.1);
  scene.grid.geometry.map_from_image = {{3, -1}, 0.5};
  return scene;
}

PlannerParams robot() {
  PlannerParams params;
  params.robot_radius = 0.2;
  return params;
}

struct Problem {
  Problem(const ob::StateSpacePtr& states, std::shared_ptr<const Planner> with)
      : space(std::make_shared<ob::SpaceInformation>(states)), planner(std::move(with)) {
    useMap(space, planner);
    space->setup();
    definition = std::make_shared<ob::ProblemDefinition>(space);
  }
  ob::ScopedState<> state(const Point2& p, double yaw) const {
    ob::ScopedState<> result(space);
    result[0] = p.x();
    result[1] = p.y();
    if (space->getStateDimension() == 3) result[2] = yaw;
    return result;
  }
  ob::PlannerStatus solve(unsigned seed = 1, unsigned iterations = 100000) {
    AGridPlanner ours(space, planner);
    ours.setSeed(seed);
    ours.setProblemDefinition(definition);
    ours.setup();
    return solve(ours, iterations);
  }
  ob::PlannerStatus solve(ob::Planner& with, unsigned iterations) const {
    ob::IterationTerminationCondition stop(iterations);
    return with.solve(stop);
  }
  og::PathGeometric& path() const {
    return *definition->getSolutionPath()->as<og::PathGeometric>();
  }

  ob::SpaceInformationPtr space;
  std::shared_ptr<const Planner> planner;
  ob::ProblemDefinitionPtr definition;
};

std::vector<ob::StateSpacePtr> spaces() {
  PlannerParams forwards;
  forwards.turning_radius = 0.4;
  forwards.motion = Motion::kDubins;
  PlannerParams long_robot;
  long_robot.footprint = {{0.4, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.4, -0.2}};
  return {std::make_shared<ob::RealVectorStateSpace>(2),
          std::make_shared<ob::SE2StateSpace>(),
          std::make_shared<ob::DubinsStateSpace>(0.4),
          std::make_shared<ob::ReedsSheppStateSpace>(0.4),
          stateSpaceFor(forwards),
          stateSpaceFor(long_robot)};
}

TEST(AGridPlanner, SolvesInEverySpaceAndTheSeedRepeats) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  for (const auto& states : spaces()) {
    Problem problem(states, planner);
    problem.definition->setStartAndGoalStates(problem.state(scene.at(8, 30), 0.5),
                                              problem.state(scene.at(38, 30), 1));
    std::vector<double> lengths;
    for (const unsigned seed : {3U, 3U, 4U}) {
      problem.definition->clearSolutionPaths();
      ASSERT_EQ(problem.solve(seed), ob::PlannerStatus::EXACT_SOLUTION) << states->getName();
      EXPECT_TRUE(problem.path().check());
      lengths.push_back(problem.path().length());
    }
    EXPECT_EQ(lengths[0], lengths[1]) << states->getName();
    EXPECT_TRUE(states->getDimension() == 2 || lengths[0] != lengths[2]) << states->getName();
  }
}

TEST(AGridPlanner, InThePlaneItIsThePathOfPlanner) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(stateSpaceFor(robot()), planner);
  problem.definition->setStartAndGoalStates(problem.state(scene.at(8, 30), 0),
                                            problem.state(scene.at(38, 30), 0));
  ASSERT_EQ(problem.solve(0), ob::PlannerStatus::EXACT_SOLUTION);
  const Plan plan = planner->plan(test::requestFrom(scene.at(8, 30), scene.at(38, 30)));
  EXPECT_NEAR(problem.path().length(), plan.length, 1e-5);
}

TEST(AGridPlanner, SaysWhyThereIsNoPath) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(std::make_shared<ob::ReedsSheppStateSpace>(0.4), planner);
  const auto free = problem.state(scene.at(8, 30), 0);
  const auto in_wall = problem.state(scene.at(21, 30), 0);
  const auto closed_room = problem.state(scene.at(52, 20), 0);
  problem.definition->setStartAndGoalStates(in_wall, free);
  EXPECT_EQ(problem.solve(), ob::PlannerStatus::INVALID_START);
  problem.definition->setStartAndGoalStates(free, in_wall);
  EXPECT_EQ(problem.solve(), ob::PlannerStatus::INVALID_GOAL);
  EXPECT_FALSE(problem.definition->hasSolutionNonExistenceProof());
  problem.definition->setStartAndGoalStates(free, closed_room);
#if OMPL_VERSION_VALUE >= 1006000
  EXPECT_EQ(problem.solve(), ob::PlannerStatus::INFEASIBLE);
#else
  EXPECT_EQ(problem.solve(), ob::PlannerStatus::TIMEOUT);
#endif
  EXPECT_TRUE(problem.definition->hasSolutionNonExistenceProof());
  EXPECT_FALSE(problem.definition->hasSolution());
}

TEST(AGridPlanner, StopsWhenItsConditionSaysSo) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(std::make_shared<ob::ReedsSheppStateSpace>(0.4), planner);
  problem.definition->setStartAndGoalStates(problem.state(scene.at(8, 30), 0),
                                            problem.state(scene.at(38, 30), 0));
  for (const unsigned iterations : {0U, 1U, 3U}) {
    EXPECT_EQ(problem.solve(1, iterations), ob::PlannerStatus::TIMEOUT);
    EXPECT_FALSE(problem.definition->hasSolution());
  }
  // A planner that was stopped goes on where it was.
  AGridPlanner ours(problem.space, planner);
  ours.setProblemDefinition(problem.definition);
  ours.setup();
  EXPECT_EQ(problem.solve(ours, 5), ob::PlannerStatus::TIMEOUT);
  EXPECT_EQ(problem.solve(ours, 100000), ob::PlannerStatus::EXACT_SOLUTION);
  ob::PlannerData data(problem.space);
  ours.getPlannerData(data);
  EXPECT_GT(data.numVertices(), 2U);
  EXPECT_GT(data.numEdges(), 0U);
}

TEST(AGridPlanner, TakesTheGoalThatIsNearest) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(stateSpaceFor(robot()), planner);
  problem.definition->addStartState(problem.state(scene.at(8, 30), 0));
  auto goals = std::make_shared<ob::GoalStates>(problem.space);
  for (const Point2& p : {Point2(52, 20), Point2(38, 30), Point2(12, 30)}) {
    goals->addState(problem.state(scene.at(p.x(), p.y()), 0));
  }
  problem.definition->setGoal(goals);
  ASSERT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_NEAR(problem.path().length(), 0.4, 1e-6);
}

/// A user's own idea of what is valid, stricter than the map.
class NotBelow : public ob::StateValidityChecker {
 public:
  NotBelow(const ob::SpaceInformationPtr& space, ob::StateValidityCheckerPtr map, double line)
      : ob::StateValidityChecker(space), map_(std::move(map)), line_(line) {}
  bool isValid(const ob::State* state) const override {
    const double* xy = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return std::abs(xy[0] - line_) > 0.3 && map_->isValid(state);
  }

 private:
  ob::StateValidityCheckerPtr map_;
  double line_;
};

TEST(AGridPlanner, ObeysWhatTheSpaceFindsValid) {
  Scene scene = test::sceneOf(std::vector<std::string>(30, std::string(50, '.')), 0.1);
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(stateSpaceFor(robot()), planner);
  const double wall = scene.at(25, 0).x();
  problem.space->setStateValidityChecker(
      std::make_shared<NotBelow>(problem.space, problem.space->getStateValidityChecker(), wall));
  problem.space->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(problem.space));
  problem.space->setup();
  problem.definition->setStartAndGoalStates(problem.state(scene.at(5, 15), 0),
                                            problem.state(scene.at(45, 15), 0));
  EXPECT_EQ(problem.solve(1, 20000), ob::PlannerStatus::TIMEOUT);
  problem.definition->setStartAndGoalStates(problem.state(scene.at(5, 15), 0),
                                            problem.state(scene.at(15, 15), 0));
  EXPECT_EQ(problem.solve(), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(AGridPlanner, RefusesSpacesAndPlannersThatItCannotUse) {
  const auto planner = std::make_shared<const Planner>(test::mapOf(rooms()), robot());
  const auto solid =
      std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
  EXPECT_THROW(useMap(solid, planner), std::invalid_argument);
  EXPECT_THROW(AGridPlanner(solid, planner), std::invalid_argument);
  const auto plane = std::make_shared<ob::SpaceInformation>(stateSpaceFor({}));
  EXPECT_THROW(AGridPlanner(plane, nullptr), std::invalid_argument);
  EXPECT_THROW(useMap(plane, nullptr), std::invalid_argument);
  EXPECT_THROW(guideSamplers(plane, {}, 1, 1), std::invalid_argument);
  EXPECT_THROW(ClearanceObjective(plane, 0, 1), std::invalid_argument);
  EXPECT_THROW(ClearanceObjective(plane, 1, -1), std::invalid_argument);
}

TEST(GuidedSamplers, DrawNearTheLeadAndSometimesAnywhere) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  for (const auto& states : spaces()) {
    Problem problem(states, planner);
    guideSamplers(problem.space, {scene.at(5, 20), scene.at(15, 20)}, 0.3, 1);
    const auto again = [&] {
      guideSamplers(problem.space, {scene.at(5, 20), scene.at(15, 20)}, 0.3, 1);
      return problem.space->allocStateSampler();
    };
    const auto first = again();
    const auto second = again();
    auto state = problem.state({0, 0}, 0);
    auto same = problem.state({0, 0}, 0);
    int near = 0;
    for (int i = 0; i < 500; ++i) {
      first->sampleUniform(state.get());
      second->sampleUniform(same.get());
      EXPECT_EQ(state, same);
      const Pose2 image_from_map = inverse(scene.grid.geometry.map_from_image);
      const Point2 p = image_from_map * Point2(state[0], state[1]);
      near += std::abs(p.y() - 2.05) < 1 && p.x() < 2.6 ? 1 : 0;
    }
    EXPECT_GT(near, 350);
    EXPECT_LT(near, 470);
  }
}

TEST(GuidedSamplers, LetAPlannerOfOmplThroughADoor) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(std::make_shared<ob::ReedsSheppStateSpace>(0.4), planner);
  problem.definition->setStartAndGoalStates(problem.state(scene.at(8, 30), 0),
                                            problem.state(scene.at(38, 30), 1));
  const Plan lead = planner->plan(test::requestFrom(scene.at(8, 30), scene.at(38, 30)));
  std::vector<Point2> corners;
  for (const Pose2& pose : lead.path_map) corners.push_back(pose.position);
  guideSamplers(problem.space, corners, 0.4, 2);
  og::RRTConnect connect(problem.space);
  connect.setProblemDefinition(problem.definition);
  connect.setup();
  EXPECT_EQ(problem.solve(connect, 20000), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(ClearanceObjective, CountsMoreNearObstacles) {
  const Scene scene = rooms();
  const auto planner = std::make_shared<const Planner>(test::mapOf(scene), robot());
  Problem problem(stateSpaceFor(robot()), planner);
  const ClearanceObjective objective(problem.space, 0.5, 3);
  const auto near = problem.state(scene.at(3, 20), 0);
  const auto middle = problem.state(scene.at(10, 20), 0);
  EXPECT_NEAR(problem.space->getStateValidityChecker()->clearance(near.get()), 0.1, 1e-6);
  EXPECT_NEAR(objective.stateCost(near.get()).value(), 1 + 3 * 0.8, 1e-6);
  EXPECT_NEAR(objective.stateCost(middle.get()).value(), 1, 1e-6);
  const auto along_wall = problem.state(scene.at(3, 30), 0);
  const auto in_middle = problem.state(scene.at(10, 30), 0);
  EXPECT_NEAR(objective.motionCost(near.get(), along_wall.get()).value(), 3.4, 0.01);
  EXPECT_NEAR(objective.motionCost(middle.get(), in_middle.get()).value(), 1, 1e-6);
}

}  // namespace
}  // namespace agrid
