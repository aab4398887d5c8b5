// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "agrid/exchange/export.h"
#include "agrid/planning/way.h"
#include "tools/commands.h"
#include "tools/known_map.h"
#include "tools/output_directory.h"

namespace agrid::tools {
namespace {

std::string formatNames() {
  std::string names;
  for (const ExportFormatName& format : kExportFormats) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

std::vector<ExportFormatName> formatsWanted(const Arguments& arguments) {
  std::vector<ExportFormatName> wanted;
  for (const std::string& name : arguments.values("format")) {
    const auto* format = std::find_if(kExportFormats.begin(), kExportFormats.end(),
                                      [&](const auto& known) { return known.name == name; });
    if (format == kExportFormats.end()) {
      throw UsageError("there is no format '" + name + "'; there are " + formatNames());
    }
    const bool again = std::any_of(wanted.begin(), wanted.end(),
                                   [&](const auto& one) { return one.name == name; });
    if (!again) wanted.push_back(*format);
  }
  return wanted;
}

int exportFiles(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  const std::vector<ExportFormatName> formats = formatsWanted(arguments);
  PlannerParams planner_params;
  planner_params.robot_radius =
      arguments.numberOr("robot-radius", planner_params.robot_radius, 0, 1e6);
  const std::string stem = std::filesystem::path(arguments.operand(0)).stem().string();
  std::vector<std::string> files;
  for (const ExportFormatName& format : formats) files.push_back(stem + std::string(format.ending));
  OutputDirectory output(arguments.value("output"), files, arguments.has("force"));

  std::vector<std::string> warnings;
  const StoredMap known = knownBefore(arguments, warnings);
  const auto map =
      std::make_shared<const SemanticMap>(makeMap(arguments.operand(0), params, known, warnings));
  std::unique_ptr<const Planner> planner;
  ExportParams export_params;
  export_params.frame_id = known.frame_id;
  export_params.find_way = [&](const Point2& from, const Point2& to) {
    if (!planner) planner = std::make_unique<const Planner>(map, planner_params);
    return wayBetween(*planner, from, to);
  };
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Exported exported = exportMap(*map, formats[i].format, export_params);
    writeText(output.stagedPath(files[i]), exported.bytes);
    warnings.insert(warnings.end(), exported.warnings.begin(), exported.warnings.end());
  }
  output.publish();
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
  for (const std::string& file : files)
    std::cout << arguments.value("output") << "/" << file << "\n";
  return kDone;
}

}  // namespace

Command exportCommand() {
  Syntax syntax;
  syntax.command = "export";
  syntax.summary = "Writes areas, doors and objects of a map in other programs' formats.";
  syntax.operands = {"MAP.yaml"};
  syntax.options = {
      {"format", 'f', "NAME", "one of " + formatNames() + "; may be given many times", true, true},
      {"output", 'o', "DIR", "directory to write to; made if missing", true},
      {"force", 0, "", "replace files that exist"},
      {"tags", 't', "FILE.yaml", "lay stored tags over the map"},
      {"robot-radius", 0, "M", "of the robot that drives the route graph, metres (0.2)"},
  };
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, exportFiles};
}

}  // namespace agrid::tools
