// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "agrid/planning/planner.h"
#include "map/file_writer.h"
#include "tools/commands.h"
#include "tools/image_frame.h"
#include "tools/output_directory.h"
#include "tools/pairs_file.h"

namespace agrid::tools {
namespace {

/// With nine decimals the way to text and back stays far below the lattice of the paths.
std::string coordinate(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9f", value);
  std::string result(text);
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string pathCsv(const Plan& plan, const MapGeometry& geometry) {
  std::string csv = "x_px,y_px\n";
  for (const Pose2& pose : plan.path_map) {
    const Point2 p = imagePoint(pose.position, geometry);
    csv += coordinate(p.x()) + "," + coordinate(p.y()) + "\n";
  }
  return csv;
}

PlannerParams plannerParams(const Arguments& arguments) {
  PlannerParams params;
  params.robot_radius = arguments.numberOr("robot-radius", params.robot_radius, 0, 1e6);
  params.timeout = arguments.numberOr("timeout", params.timeout, 1e-3, 60);
  params.planner = arguments.valueOr("planner", params.planner);
  params.allow_unknown = arguments.has("allow-unknown");
  params.turning_radius = arguments.numberOr("turning-radius", params.turning_radius, 0, 1000);
  if (arguments.has("forwards")) params.motion = Motion::kDubins;
  if (arguments.has("strict")) params.clearance = Clearance::kStrict;
  return params;
}

PlanRequest requestOf(const Pair& pair, const MapGeometry& geometry, std::uint32_t seed) {
  PlanRequest request;
  request.start.position_map = mapPoint(pair.start_px, geometry);
  PlanPoint goal;
  goal.position_map = mapPoint(pair.goal_px, geometry);
  request.goal = goal;
  request.seed = seed;
  return request;
}

std::string rowOf(const Pair& pair, const Plan& plan, const MapGeometry& geometry) {
  char numbers[96];
  const double length = plan.length / geometry.resolution;
  if (plan.status == PlanStatus::kSuccess) {
    std::snprintf(numbers, sizeof numbers, "%.6f,%.4f", length, plan.planning_time * 1e3);
  } else {
    std::snprintf(numbers, sizeof numbers, ",%.4f", plan.planning_time * 1e3);
  }
  return pair.id + "," + toString(plan.status) + "," + numbers + "\n";
}

struct Answers {
  std::string table = "id,status,length_px,milliseconds\n";
  std::size_t found = 0;
  std::vector<std::string> path_files;
  std::vector<std::string> paths;
};

Answers answerAll(const Planner& planner, const MapGeometry& geometry,
                  const std::vector<Pair>& pairs, std::uint32_t seed) {
  const bool show = isatty(STDERR_FILENO) != 0;
  Answers answers;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (show && i % 16 == 0) std::cerr << "\r" << i << " of " << pairs.size() << " pairs ";
    const Plan plan = planner.plan(requestOf(pairs[i], geometry, seed));
    answers.table += rowOf(pairs[i], plan, geometry);
    if (plan.status != PlanStatus::kSuccess) continue;
    ++answers.found;
    answers.path_files.push_back(pairs[i].id + ".csv");
    answers.paths.push_back(pathCsv(plan, geometry));
  }
  if (show) std::cerr << "\r" << pairs.size() << " of " << pairs.size() << " pairs\n";
  return answers;
}

int plan(const Arguments& arguments) {
  using Clock = std::chrono::steady_clock;
  const PlannerParams params = plannerParams(arguments);
  const auto seed = static_cast<std::uint32_t>(arguments.integerOr("seed", 0, 0, 4294967295));
  const std::vector<Pair> pairs = readPairs(arguments.value("pairs"));
  MapFileParams file_params;
  // pairs and the lengths they are compared with go by the colours of the picture
  file_params.skip_opaque_alpha = !arguments.has("count-alpha");
  const LoadedMap loaded = loadMap(arguments.operand(0), file_params);
  for (const std::string& warning : loaded.warnings) std::cerr << "warning: " << warning << "\n";
  FileWriter output(arguments.value("output"));

  const auto map = std::make_shared<const OccupancyMap>(loaded.grid);
  const auto annotated =
      std::make_shared<const SemanticMap>(annotate(extractStructure(map, {}), {}, {}));
  const auto begin = Clock::now();
  const Planner planner(annotated, params);
  const double build_time = std::chrono::duration<double>(Clock::now() - begin).count();

  const Answers answers = answerAll(planner, map->geometry(), pairs, seed);
  if (arguments.has("paths")) {
    OutputDirectory directory(arguments.value("paths"), answers.path_files, true);
    for (std::size_t i = 0; i < answers.paths.size(); ++i) {
      writeText(directory.stagedPath(answers.path_files[i]), answers.paths[i]);
    }
    directory.publish();
  }
  output.write(answers.table);
  output.commit();
  std::cout << answers.found << " of " << pairs.size() << " pairs have a path; prepared in "
            << shortNumber(build_time) << " s\n";
  return kDone;
}

}  // namespace

Command planCommand() {
  Syntax syntax;
  syntax.command = "plan";
  syntax.summary = "Answers start-goal pairs with collision-free paths.";
  syntax.operands = {"MAP.yaml"};
  syntax.options = {
      {"pairs", 0, "FILE", "CSV: id,start_x_px,start_y_px,goal_x_px,goal_y_px", true},
      {"output", 'o', "OUT", "CSV to write: id,status,length_px,milliseconds", true},
      {"paths", 0, "DIR", "also write each path's points to DIR/<id>.csv: x_px,y_px"},
      {"robot-radius", 0, "M", "metres (0.2)"},
      {"turning-radius", 0, "M", "metres; 0 turns on the spot (0)"},
      {"forwards", 0, "", "with a turning radius: never drive backwards"},
      {"strict", 0, "", "keep every point of the path so far from every obstacle"},
      {"allow-unknown", 0, "", "unknown space is no obstacle"},
      {"count-alpha", 0, "", "count an opaque transparency as a colour, as map_server does"},
      {"planner", 0, "NAME", "AGrid, or a geometric planner of OMPL (AGrid)"},
      {"timeout", 0, "S", "seconds for one pair (5)"},
      {"seed", 0, "N", "same seed, same paths (0)"},
  };
  return {syntax, plan};
}

}  // namespace agrid::tools
