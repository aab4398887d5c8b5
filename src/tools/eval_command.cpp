// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

#include "agrid/map/map_io.h"
#include "map/file_writer.h"
#include "tools/case_scoring.h"
#include "tools/commands.h"
#include "tools/door_tables.h"
#include "tools/eval_tables.h"

namespace agrid::tools {
namespace {

std::vector<EvalCase> casesOf(const Arguments& arguments) {
  const std::string& folder = arguments.operand(0);
  EvalCases found = findEvalCases(folder, arguments.valueOr("truth", ""));
  for (const std::string& name : found.without_truth) {
    std::cerr << "warning: " << name << ": no truth, passed over\n";
  }
  if (found.cases.empty()) {
    const char* what = found.without_truth.empty() ? ": no maps there" : ": no map has truth";
    throw FileError(FileErrorCode::kPath, folder + what);
  }
  return std::move(found.cases);
}

/// A file to be written when all is known; none if it is not asked for.
std::unique_ptr<FileWriter> writerOf(const Arguments& arguments, const std::string& option) {
  if (!arguments.has(option)) return nullptr;
  return std::make_unique<FileWriter>(arguments.value(option));
}

int eval(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  const auto cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  const auto threads = static_cast<int>(arguments.integerOr("threads", cores, 1, 256));
  if (arguments.has("csv") && arguments.valueOr("doors", "") == arguments.value("csv")) {
    throw UsageError("--csv and --doors name the same file");
  }
  const std::vector<EvalCase> cases = casesOf(arguments);
  const std::unique_ptr<FileWriter> csv = writerOf(arguments, "csv");
  const std::unique_ptr<FileWriter> doors = writerOf(arguments, "doors");
  const std::vector<View> views = evalViews(arguments.has("robustness"));

  const std::vector<CaseScores> scores = scoreCases(cases, params, views, threads);
  for (const CaseScores& one : scores) {
    for (const std::string& warning : one.warnings) {
      std::cerr << "warning: " << one.about.name << ": " << warning << "\n";
    }
  }
  if (csv) csv->write(scoresCsv(scores, views));
  if (doors) doors->write(doorsCsv(scores));
  if (csv) csv->commit();
  if (doors) doors->commit();
  std::cout << scoreTables(scores);
  if (views.size() > 1) std::cout << "\n" << robustnessTable(scores, views);
  if (doors) std::cout << "\n" << reliabilityTable(scores);
  return kDone;
}

}  // namespace

Command evalCommand() {
  Syntax syntax;
  syntax.command = "eval";
  syntax.summary = "Scores areas and doors of a folder of maps against rooms drawn by people.";
  syntax.operands = {"DIR"};
  syntax.options = {
      {"truth", 0, "DIR", "look here first for the truth, in the same layout"},
      {"csv", 0, "FILE", "also write every score of every map"},
      {"doors", 0, "FILE", "also write every door and whether it is true, and show how often"},
      {"robustness", 0, "", "score each map also turned, at 0.1 and 0.025 m, and with noise"},
      {"threads", 0, "N", "maps at a time (all cores)"},
  };
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, eval};
}

}  // namespace agrid::tools
