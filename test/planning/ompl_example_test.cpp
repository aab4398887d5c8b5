// SPDX-License-Identifier: BSD-3-Clause
// The example of doc/planning.md, word for word.
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "agrid/planning/ompl_planner.h"
#include "planning/three_rooms.h"

namespace agrid {
namespace {

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Without the blanks at the beginning of each line.
std::string flat(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != std::string::npos) result += line.substr(begin) + "\n";
  }
  return result;
}

TEST(OmplExample, Solves) {
  const test::Scene scene = test::threeRooms();
  const auto map = test::mapOf(scene);
  const agrid::PlannerParams params = test::pointRobot();
  const Point2 from = scene.at(2, 4);
  const Point2 to = scene.at(14, 4);
  // clang-format off
  auto planner = std::make_shared<const agrid::Planner>(map, params);
  ompl::geometric::SimpleSetup setup(std::make_shared<ompl::base::ReedsSheppStateSpace>(0.5));
  agrid::useMap(setup.getSpaceInformation(), planner);  // bounds, exact validity
  ompl::base::ScopedState<ompl::base::SE2StateSpace> start(setup.getStateSpace()), goal(start);
  start->setXY(from.x(), from.y());  // map frame, metres
  start->setYaw(0);
  goal->setXY(to.x(), to.y());
  goal->setYaw(1.57);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<agrid::AGridPlanner>(setup.getSpaceInformation(), planner));
  const bool found = setup.solve(10.0) == ompl::base::PlannerStatus::EXACT_SOLUTION;
  // clang-format on
  EXPECT_TRUE(found);
  EXPECT_TRUE(setup.getSolutionPath().check());
}

TEST(OmplExample, IsTheOneOfTheDocument) {
  const std::string tests = std::string(AGRID_TEST_DATA) + "/..";
  const std::string document = textOf(tests + "/../doc/planning.md");
  const std::size_t begin = document.find("```cpp\n");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t code = begin + std::string("```cpp\n").size();
  const std::string example = document.substr(code, document.find("```", code) - code);
  EXPECT_GT(example.size(), 500U);
  EXPECT_NE(flat(textOf(tests + "/planning/ompl_example_test.cpp")).find(flat(example)),
            std::string::npos)
      << example;
}

}  // namespace
}  // namespace agrid
