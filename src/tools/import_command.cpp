// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "agrid/exchange/import.h"
#include "exchange/place_files.h"
#include "map/file_writer.h"
#include "storage/snapshot.h"
#include "tools/commands.h"
#include "tools/image_frame.h"
#include "tools/known_map.h"
#include "tools/room_pictures.h"

namespace agrid::tools {
namespace {

/// Checks what was asked for, before any work.
void checkSources(const Arguments& arguments) {
  int areas = 0;
  for (const char* option : {"labels", "locations", "geojson"}) areas += arguments.has(option);
  if (areas > 1) throw UsageError("areas come from one of --labels, --locations and --geojson");
  if (areas == 0 && !arguments.has("doors") && !arguments.has("objects")) {
    throw UsageError(
        "nothing to import: give --labels, --locations, --geojson, --doors or "
        "--objects");
  }
  const std::string& output = arguments.value("output");
  if (std::filesystem::exists(output) && !arguments.has("force")) {
    throw UsageError(output + " is there already (--force replaces it)");
  }
}

GivenPlace readPlace(const Arguments& arguments, const OccupancyMap& map) {
  GivenPlace place;
  if (arguments.has("geojson")) place = readGeoJson(arguments.value("geojson"), map);
  if (arguments.has("locations")) readLocations(arguments.value("locations"), map, place);
  if (arguments.has("labels")) {
    place.labels = readAreaPicture(arguments.value("labels"), map.geometry());
    place.areas.resize(*std::max_element(place.labels.begin(), place.labels.end()));
  }
  if (arguments.has("doors")) {
    for (const PlaceDoor& door : readPlaceDoors(arguments.value("doors"))) {
      place.doors.push_back(tagOf(door));
    }
  }
  if (arguments.has("objects")) {
    const std::vector<ObjectTag> objects = readPlaceObjects(arguments.value("objects"));
    place.objects.insert(place.objects.end(), objects.begin(), objects.end());
  }
  return place;
}

int importFiles(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  checkSources(arguments);
  std::vector<std::string> warnings;
  const SemanticMap bare = makeMap(arguments.operand(0), params, {}, warnings);
  const GivenPlace place = readPlace(arguments, bare.map());
  const FittedTags fitted = fitTags(bare, place);
  warnings.insert(warnings.end(), fitted.warnings.begin(), fitted.warnings.end());
  const StoredMap stored{bare.map().digest(), arguments.valueOr("frame", "map"), fitted.knowledge};
  FileWriter output(arguments.value("output"));
  output.write(snapshotText({stored, 0, 0}));
  output.commit();
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
  std::cout << arguments.value("output") << ": " << fitted.knowledge.areas.size() << " areas, "
            << fitted.knowledge.doors.size() << " doors, " << fitted.knowledge.objects.size()
            << " objects";
  if (!place.areas.empty()) std::cout << "; mean IoU of areas " << shortNumber(fitted.mean_iou);
  std::cout << "\n";
  return kDone;
}

}  // namespace

Command importCommand() {
  Syntax syntax;
  syntax.command = "import";
  syntax.summary = "Makes stored tags of areas, doors and objects that people have elsewhere.";
  syntax.operands = {"MAP.yaml"};
  syntax.options = {
      {"labels", 0, "IMAGE", "areas: a label image, or a picture with rooms in colours or white"},
      {"locations", 0, "FILE", "areas: locations.yaml with names and polygons in pixels"},
      {"geojson", 0, "FILE", "areas, doors and objects in metres of the map's frame"},
      {"doors", 0, "FILE", "doors.yaml with two corners of each"},
      {"objects", 0, "FILE", "objects.yaml with a pose of each"},
      {"output", 'o', "STORED.yaml", "stored tags to write", true},
      {"frame", 0, "NAME", "of the map (map)"},
      {"force", 0, "", "replace the file if it exists"},
  };
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, importFiles};
}

}  // namespace agrid::tools
