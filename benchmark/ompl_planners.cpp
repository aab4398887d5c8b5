// SPDX-License-Identifier: BSD-3-Clause
// Prints how AGridPlanner and planners of OMPL do on the same problems, by ompl::tools::Benchmark:
// in the plane and in Reeds-Shepp space, all with the map's exact validity, the same limit of CPU
// time, the path simplifier of OMPL, and the same goal: each may stop at 1.05 times the best length
// known for a circle that turns on the spot.
// usage: agrid_ompl_planners [--shared DIR] [--only MAP]... [--pairs N] [--runs N] [--cpu-seconds
// S]
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Console.h>

#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "agrid/planning/ompl_planner.h"
#include "tools/arguments.h"
#include "tools/image_frame.h"
#include "tools/pairs_file.h"

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using agrid::Point2;

constexpr double kGoodEnough = 1.05;
constexpr double kTurningRadius = 0.5;

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Stops a planner after so much CPU time of the process, all of its threads counted.
class CpuLimited : public ob::Planner {
 public:
  CpuLimited(ob::PlannerPtr planner, const std::string& name, bool guided, double limit)
      : ob::Planner(planner->getSpaceInformation(), name),
        is_guided(guided),
        planner_(std::move(planner)),
        limit_(limit) {}
  void setProblemDefinition(const ob::ProblemDefinitionPtr& definition) override {
    ob::Planner::setProblemDefinition(definition);
    planner_->setProblemDefinition(definition);
  }
  void setup() override {
    ob::Planner::setup();
    planner_->setup();
  }
  void clear() override {
    ob::Planner::clear();
    planner_->clear();
  }
  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& stop) override {
    const double begin = cpuSeconds();
    const ob::PlannerStatus status = planner_->solve(
        ob::PlannerTerminationCondition([&] { return stop() || cpuSeconds() - begin > limit_; }));
    used = cpuSeconds() - begin;
    return status;
  }

  const bool is_guided;
  double used = 0;  ///< [s]

 private:
  ob::PlannerPtr planner_;
  double limit_;
};

struct Row {
  int runs = 0;
  int solved = 0;
  std::vector<double> seconds;
  std::vector<double> ratios;
};

struct Effort {
  std::size_t pairs;
  unsigned runs;
  double cpu_seconds;
};

double middle(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double number(const ompl::tools::Benchmark::RunProperties& run, const std::string& name) {
  const auto found = run.find(name);
  return found == run.end() ? 0 : std::stod(found->second);
}

/// The problems of one map in one space.
class Arena {
 public:
  Arena(std::shared_ptr<const agrid::Planner> planner, bool curves, const Effort& effort)
      : planner_(std::move(planner)), curves_(curves), effort_(effort) {}

  void run(const Point2& start, const Point2& goal, std::map<std::string, Row>& rows) {
    const auto lead = leadOf(start, goal);
    if (lead.empty()) return;
    og::SimpleSetup setup(space());
    agrid::useMap(setup.getSpaceInformation(), planner_);
    setup.setStartAndGoalStates(state(setup, start), state(setup, goal));
    const double good = lengthOf(lead);
    auto objective =
        std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation());
    objective->setCostThreshold(ob::Cost(kGoodEnough * good));
    setup.setOptimizationObjective(objective);
    setup.setup();
    ompl::tools::Benchmark benchmark(setup);
    for (const auto& planner : planners(setup.getSpaceInformation())) benchmark.addPlanner(planner);
    guideOnlyTheGuided(benchmark, setup, lead);
    benchmark.benchmark({600, 4096, effort_.runs, 1, false, false, true});
    for (const auto& planner : benchmark.getRecordedExperimentData().planners) {
      for (const auto& run : planner.runs) add(run, good, rows[planner.name]);
    }
  }

 private:
  ob::StateSpacePtr space() const {
    if (curves_) return std::make_shared<ob::ReedsSheppStateSpace>(kTurningRadius);
    return std::make_shared<ob::RealVectorStateSpace>(2);
  }
  std::vector<Point2> leadOf(const Point2& start, const Point2& goal) const {
    agrid::PlanRequest request;
    request.start.position_map = start;
    agrid::PlanPoint end;
    end.position_map = goal;
    request.goal = end;
    std::vector<Point2> corners;
    for (const agrid::Pose2& pose : planner_->plan(request).path_map) {
      corners.push_back(pose.position);
    }
    return corners;
  }
  static double lengthOf(const std::vector<Point2>& corners) {
    double length = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      length += (corners[i] - corners[i - 1]).norm();
    }
    return length;
  }
  /// Heading 0 at both ends, in every planner's way alike.
  static ob::ScopedState<> state(const og::SimpleSetup& setup, const Point2& position) {
    ob::ScopedState<> result(setup.getStateSpace());
    result[0] = position.x();
    result[1] = position.y();
    if (setup.getStateSpace()->getDimension() == 3) result[2] = 0;
    return result;
  }
  std::vector<ob::PlannerPtr> planners(const ob::SpaceInformationPtr& space) const {
    const auto limited = [&](ob::PlannerPtr planner, const std::string& name, bool guided) {
      return std::make_shared<CpuLimited>(std::move(planner), name, guided, effort_.cpu_seconds);
    };
    return {
        limited(std::make_shared<agrid::AGridPlanner>(space, planner_), "1 AGridPlanner", false),
        limited(std::make_shared<og::RRTConnect>(space), "2 RRTConnect", false),
        limited(std::make_shared<og::RRTConnect>(space), "3 RRTConnect, guided", true),
        limited(std::make_shared<og::PRMstar>(space), "4 PRM*", false),
        limited(std::make_shared<og::BITstar>(space), "5 BIT*", false),
        limited(std::make_shared<og::RRTstar>(space), "6 RRT*", false)};
  }
  void guideOnlyTheGuided(ompl::tools::Benchmark& benchmark, const og::SimpleSetup& setup,
                          const std::vector<Point2>& lead) const {
    benchmark.setPlannerSwitchEvent([&setup, lead](const ob::PlannerPtr& planner) {
      setup.getStateSpace()->clearStateSamplerAllocator();
      if (!dynamic_cast<const CpuLimited&>(*planner).is_guided) return;
      agrid::guideSamplers(setup.getSpaceInformation(), lead, kTurningRadius, 1);
    });
    benchmark.setPostRunEvent(
        [](const ob::PlannerPtr& planner, ompl::tools::Benchmark::RunProperties& run) {
          run["cpu REAL"] = std::to_string(dynamic_cast<const CpuLimited&>(*planner).used);
        });
  }
  static void add(const ompl::tools::Benchmark::RunProperties& run, double good, Row& row) {
    ++row.runs;
    const bool solved = number(run, "solved BOOLEAN") > 0 &&
                        number(run, "approximate solution BOOLEAN") == 0 &&
                        number(run, "correct solution BOOLEAN") > 0;
    row.seconds.push_back(number(run, "cpu REAL") + number(run, "simplification time REAL"));
    if (!solved) return;
    ++row.solved;
    row.ratios.push_back(number(run, "simplified solution length REAL") / good);
  }

  std::shared_ptr<const agrid::Planner> planner_;
  bool curves_;
  Effort effort_;
};

void print(const std::string& space, const std::map<std::string, Row>& rows) {
  std::printf("\n| %s | solved | CPU s: median | max | length ratio: median | max |\n",
              space.c_str());
  std::printf("|---|---|---|---|---|---|\n");
  for (const auto& [name, row] : rows) {
    const auto most = [](const std::vector<double>& values) {
      return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
    };
    std::printf("| %s | %d of %d | %.4f | %.3f | %.3f | %.3f |\n",
                name.substr(sizeof "geometric_1").c_str(), row.solved, row.runs,
                middle(row.seconds), most(row.seconds), middle(row.ratios), most(row.ratios));
  }
}

std::shared_ptr<const agrid::Planner> plannerOf(const agrid::OccupancyGrid& grid) {
  const auto map = std::make_shared<const agrid::OccupancyMap>(grid);
  return std::make_shared<const agrid::Planner>(
      std::make_shared<const agrid::SemanticMap>(
          agrid::annotate(agrid::extractStructure(map, {}), {}, {})),
      agrid::PlannerParams{});
}

void measure(const agrid::tools::Arguments& arguments) {
  const std::string shared = arguments.valueOr("shared", "../shared");
  const Effort effort{static_cast<std::size_t>(arguments.integerOr("pairs", 3, 1, 1000)),
                      static_cast<unsigned>(arguments.integerOr("runs", 3, 1, 1000)),
                      arguments.numberOr("cpu-seconds", 1, 1e-3, 600)};
  std::vector<std::string> names = arguments.values("only");
  if (names.empty()) names = {"lab_ipa", "NLB", "office_c"};
  std::map<std::string, Row> plane;
  std::map<std::string, Row> curves;
  for (const std::string& name : names) {
    agrid::MapFileParams file_params;
    file_params.skip_opaque_alpha = true;
    const auto grid = agrid::loadMap(shared + "/maps/bormann/" + name + ".yaml", file_params).grid;
    const auto planner = plannerOf(grid);
    auto pairs = agrid::tools::readPairs(shared + "/bench/planning_pairs/" + name + ".csv");
    pairs.resize(std::min(pairs.size(), effort.pairs));
    for (const agrid::tools::Pair& pair : pairs) {
      const Point2 start = agrid::tools::mapPoint(pair.start_px, grid.geometry);
      const Point2 goal = agrid::tools::mapPoint(pair.goal_px, grid.geometry);
      Arena(planner, false, effort).run(start, goal, plane);
      Arena(planner, true, effort).run(start, goal, curves);
    }
  }
  print("plane", plane);
  print("Reeds-Shepp, 0.5 m", curves);
}

agrid::tools::Syntax syntax() {
  agrid::tools::Syntax syntax;
  syntax.command = "agrid_ompl_planners";
  syntax.summary = "Compares AGridPlanner with planners of OMPL on the same problems.";
  syntax.options = {
      {"shared", 0, "DIR", "has maps/bormann and bench/planning_pairs (../shared)"},
      {"only", 0, "MAP", "only this map, such as lab_ipa", false, true},
      {"pairs", 0, "N", "the first pairs of each map (3)"},
      {"runs", 0, "N", "of each planner on each pair (3)"},
      {"cpu-seconds", 0, "S", "for each run (1)"},
  };
  return syntax;
}

}  // namespace

int main(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
  try {
    const agrid::tools::Arguments arguments(syntax(), {argv + 1, argv + argc});
    if (arguments.has("help")) {
      std::cout << agrid::tools::helpText(syntax());
      return 0;
    }
    measure(arguments);
  } catch (const std::exception& error) {
    std::cerr << "agrid_ompl_planners: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
