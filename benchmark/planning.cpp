// SPDX-License-Identifier: BSD-3-Clause
// Prints how right, how short and how fast plans are, on floor plans with known best lengths and on
// generated offices: beside one exact distance transform of the same map and a pixel A*, all in one
// run and on one thread (building uses all). Each query is timed three times, the shortest counts.
// usage: agrid_planning [--shared DIR] [--generated DIR --sizes 2000,5000] [--only NAME]
//                       [--pairs N] [--reference-seconds S] [--robot-radius M] [--csv OUT.csv]
#include <algorithm>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "map/file_writer.h"
#include "planning/figures.h"
#include "planning/subject.h"
#include "planning/table.h"
#include "tools/arguments.h"

namespace {

using agrid::bench::Subject;
using agrid::tools::Arguments;

agrid::tools::Syntax syntax() {
  agrid::tools::Syntax syntax;
  syntax.command = "agrid_planning";
  syntax.summary =
      "Measures plans on floor plans with known best lengths and on generated offices.";
  syntax.options = {
      {"shared", 0, "DIR", "has maps/bormann, bench/planning_pairs and tools (../shared)"},
      {"generated", 0, "DIR", "also generated offices, kept in this directory"},
      {"sizes", 0, "LIST", "their sides in pixels (2000,5000,10000)"},
      {"only", 0, "NAME", "only this map, such as lab_ipa or office_2000", false, true},
      {"pairs", 0, "N", "pairs drawn for each generated office (100)"},
      {"reference-seconds", 0, "S", "for pixel A* and reference lengths, each map (60)"},
      {"robot-radius", 0, "M", "metres (0.2); best lengths are known for 0.2"},
      {"csv", 0, "OUT", "also write the table to this file"},
  };
  return syntax;
}

std::vector<int> sizesOf(const Arguments& arguments) {
  std::vector<int> sizes;
  std::stringstream stream(arguments.valueOr("sizes", "2000,5000,10000"));
  for (std::string word; std::getline(stream, word, ',');) {
    const auto size = agrid::tools::parseNumber(word);
    if (!size || *size < 500 || *size > 60000) {
      throw agrid::tools::UsageError("--sizes: '" + word + "' is not in [500, 60000]");
    }
    sizes.push_back(static_cast<int>(*size));
  }
  return sizes;
}

std::vector<Subject> subjectsOf(const Arguments& arguments) {
  const std::string shared = arguments.valueOr("shared", "../shared");
  const std::vector<std::string> only = arguments.values("only");
  const auto isWanted = [&](const std::string& name) {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  };
  std::vector<Subject> subjects;
  for (const Subject& subject : agrid::bench::mapsWithPairs(shared)) {
    if (isWanted(subject.name)) subjects.push_back(subject);
  }
  if (!arguments.has("generated")) return subjects;
  for (const int size : sizesOf(arguments)) {
    if (!isWanted("office_" + std::to_string(size))) continue;
    subjects.push_back(agrid::bench::generatedOffice(shared, arguments.value("generated"), size));
  }
  return subjects;
}

void run(const Arguments& arguments) {
  agrid::bench::Effort effort;
  effort.robot_radius = arguments.numberOr("robot-radius", effort.robot_radius, 0, 100);
  effort.drawn_pairs = static_cast<int>(arguments.integerOr("pairs", effort.drawn_pairs, 1, 10000));
  effort.reference_seconds =
      arguments.numberOr("reference-seconds", effort.reference_seconds, 0, 1e6);
  std::vector<agrid::bench::Figures> figures;
  for (const Subject& subject : subjectsOf(arguments)) {
    figures.push_back(agrid::bench::measure(subject, effort));
  }
  std::cout << agrid::bench::markdownTable(figures);
  if (arguments.has("csv")) {
    agrid::FileWriter file(arguments.value("csv"));
    file.write(agrid::bench::csvTable(figures));
    file.commit();
  }
}

/// The texts of tools::Arguments are those of a command of agrid_map_tool.
std::string withoutTool(std::string text) {
  const std::string tool = "agrid_map_tool ";
  return text.erase(text.find(tool), tool.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments(syntax(), {argv + 1, argv + argc});
    if (arguments.has("help")) {
      std::cout << withoutTool(agrid::tools::helpText(syntax()));
      return 0;
    }
    run(arguments);
  } catch (const agrid::tools::UsageError& error) {
    std::cerr << "agrid_planning: " << error.what() << "\n"
              << withoutTool(agrid::tools::usageLine(syntax())) << "\n";
    return 64;
  } catch (const std::exception& error) {
    std::cerr << "agrid_planning: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
