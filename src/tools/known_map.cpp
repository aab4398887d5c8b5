// SPDX-License-Identifier: BSD-3-Clause
#include "tools/known_map.h"

#include <memory>
#include <utility>

#include "agrid/map/map_io.h"

namespace agrid::tools {
namespace {

void append(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

}  // namespace

StoredMap knownBefore(const Arguments& arguments, std::vector<std::string>& warnings) {
  StoredMap nothing;
  nothing.frame_id = "map";
  if (!arguments.has("tags")) return nothing;
  StoreContents contents = readStoredMap(arguments.value("tags"));
  append(warnings, contents.errors);
  append(warnings, contents.warnings);
  return std::move(contents.map);
}

SemanticMap makeMap(const std::string& yaml_path, const ConversionParams& params,
                    const StoredMap& known, std::vector<std::string>& warnings,
                    const StageListener& on_stage) {
  if (on_stage) on_stage("load");
  std::shared_ptr<const OccupancyMap> map;
  {
    MapFileParams file_params;
    file_params.max_pixels = params.map.max_pixels;
    const LoadedMap loaded = loadMap(yaml_path, file_params);
    append(warnings, loaded.warnings);
    map = std::make_shared<const OccupancyMap>(loaded.grid, params.map);
  }
  const Structure structure = extractStructure(map, params.pipeline, on_stage);
  LaidKnowledge laid = layKnowledge(structure, known, params.pipeline, on_stage);
  append(warnings, map->warnings());
  append(warnings, structure.walls.warnings);
  append(warnings, laid.map.area_map.warnings);
  append(warnings, laid.report);
  return std::move(laid.map);
}

}  // namespace agrid::tools
