// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "agrid/storage.h"
#include "exchange/label_image.h"
#include "grid/edge_image.h"
#include "storage/snapshot.h"
#include "tools/commands.h"
#include "tools/image_frame.h"
#include "tools/known_map.h"
#include "tools/output_directory.h"
#include "tools/pictures.h"
#include "tools/reports.h"
#include "tools/stage_meter.h"

namespace agrid::tools {
namespace {

using Warnings = std::vector<std::string>;

const std::vector<std::string> kFiles{"edges.png",  "walls.png",    "grid.png",   "areas.png",
                                      "graph.png",  "overview.png", "labels.png", "doors.csv",
                                      "graph.json", "summary.json"};

constexpr const char* kTagsFile = "tags.yaml";

void writePictures(const SemanticMap& map, const WallParams& params, OutputDirectory& output) {
  writePng(output.stagedPath("edges.png"), drawEdges(detectEdges(map.map(), params)));
  writePng(output.stagedPath("walls.png"), drawWalls(map.structure));
  writePng(output.stagedPath("grid.png"), drawGrid(map.structure));
  writePng(output.stagedPath("areas.png"), drawAreas(map));
  writePng(output.stagedPath("graph.png"), drawGraph(map));
  writePng(output.stagedPath("overview.png"), drawOverview(map));
}

std::string inAll(const std::vector<StageCost>& costs) {
  double seconds = 0;
  double megabytes = 0;
  for (const StageCost& cost : costs) {
    seconds += cost.seconds;
    megabytes = std::max(megabytes, cost.peak_megabytes);
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << seconds << " s, at most " << std::setprecision(0)
       << megabytes << " MB";
  return text.str();
}

std::vector<std::string> filesToWrite(const Arguments& arguments) {
  std::vector<std::string> files = kFiles;
  if (arguments.has("save-tags")) files.emplace_back(kTagsFile);
  return files;
}

int convert(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  OutputDirectory output(arguments.value("output"), filesToWrite(arguments),
                         arguments.has("force"));
  StageMeter meter("convert");
  Warnings warnings;
  const StoredMap known = knownBefore(arguments, warnings);
  const SemanticMap map = makeMap(arguments.operand(0), params, known, warnings,
                                  [&](const std::string& stage) { meter.begin(stage); });
  const MapGeometry& geometry = map.map().geometry();
  meter.begin("write");
  writePictures(map, params.pipeline.walls, output);
  writePng(output.stagedPath("labels.png"),
           labelImage(map.area_map.pixel_labels.vector(), geometry));
  writeText(output.stagedPath("doors.csv"), segmentsCsv(doorSegments(map.area_map), geometry));
  writeText(output.stagedPath("graph.json"), graphJson(map));
  if (arguments.has("save-tags")) {
    const StoredMap after{map.map().digest(), known.frame_id, map.knowledge};
    writeText(output.stagedPath(kTagsFile), snapshotText({after, 0, 0}));
  }
  meter.end();
  writeText(output.stagedPath("summary.json"), summaryJson(map, meter.costs(), warnings));
  output.publish();
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
  std::cout << arguments.operand(0) << ": " << map.grid().cellCount() << " cells, "
            << map.area_map.areas.size() << " areas, " << map.area_map.doors.size() << " doors, "
            << inAll(meter.costs()) << "\n";
  return kDone;
}

}  // namespace

Command convertCommand() {
  Syntax syntax;
  syntax.command = "convert";
  syntax.summary = "Finds walls, cells, areas and doors of a map_server map, and draws them.";
  syntax.operands = {"MAP.yaml"};
  syntax.options = {
      {"output", 'o', "DIR", "directory to write to; made if missing", true},
      {"force", 0, "", "replace files that exist"},
      {"tags", 't', "FILE.yaml", "lay stored tags over the map"},
      {"save-tags", 0, "", "write all that is known then as tags.yaml"},
  };
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, convert};
}

}  // namespace agrid::tools
