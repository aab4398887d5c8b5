// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>

#include "agrid/map/map_io.h"
#include "tools/commands.h"
#include "tools/laid_knowledge.h"
#include "tools/pipeline_options.h"
#include "tools/place_findings.h"
#include "tools/stored_file.h"

namespace agrid::tools {
namespace {

LaidKnowledge layOverFile(const std::string& map_path, const ConversionParams& params,
                          const StoredMap& known) {
  MapFileParams file_params;
  file_params.max_pixels = params.map.max_pixels;
  const LoadedMap loaded = loadMap(map_path, file_params);
  for (const std::string& warning : loaded.warnings) std::cerr << "warning: " << warning << "\n";
  const auto map = std::make_shared<const OccupancyMap>(loaded.grid, params.map);
  LaidKnowledge laid = layKnowledge(extractStructure(map, params.pipeline), known, params.pipeline);
  for (const std::string& line : laid.report) std::cerr << "on this map: " << line << "\n";
  return laid;
}

void checkByOutlines(const Knowledge& knowledge, Sentences& findings) {
  findInTags(knowledge, findings);
  const auto without =
      std::count_if(knowledge.areas.begin(), knowledge.areas.end(),
                    [](const AreaTag& area) { return area.outline_map.size() < 3; });
  if (without > 0) {
    std::cerr << "without an outline: " << without << " of " << knowledge.areas.size()
              << " areas; doors, seeds and places of objects are checked with --map only\n";
    return;
  }
  findInPlace(viewOfOutlines(knowledge), findings);
}

int check(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  const StoreContents contents = readStoredMap(arguments.operand(0));
  Sentences findings;
  for (const std::string& error : contents.errors) findings.addOnPlace("damaged: " + error);
  for (const std::string& warning : contents.warnings) findings.addOnPlace(warning);
  if (arguments.has("map")) {
    const LaidKnowledge laid = layOverFile(arguments.value("map"), params, contents.map);
    findInTags(laid.map.knowledge, findings);
    findInPlace(viewOfMap(laid.map, laid.laid), findings);
  } else {
    checkByOutlines(contents.map.knowledge, findings);
  }
  return printFound(findings.lines());
}

}  // namespace

Command checkCommand() {
  Syntax syntax;
  syntax.command = "check";
  syntax.summary = "Tells in sentences what is wrong with a file of stored tags.";
  syntax.operands = {"FILE.yaml"};
  syntax.options = {{"map", 'm', "MAP.yaml", "judge by this map, not by outlines as last seen"}};
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, check, kFileFailed};
}

}  // namespace agrid::tools
