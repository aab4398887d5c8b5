// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "agrid/evaluation/office_generator.h"
#include "agrid/map/map_io.h"
#include "exchange/label_image.h"
#include "tools/commands.h"
#include "tools/image_frame.h"
#include "tools/output_directory.h"
#include "tools/stage_meter.h"

namespace agrid::tools {
namespace {

int generate(const Arguments& arguments) {
  OfficeParams params;
  params.size = static_cast<int>(arguments.integerOr("size", params.size, 100, 20000));
  params.seed = static_cast<std::uint32_t>(arguments.integerOr("seed", params.seed, 0, 4294967295));
  params.resolution = arguments.numberOr("resolution", params.resolution, 0.02, 0.2);
  params.furniture = !arguments.has("no-furniture");
  params.noise = !arguments.has("no-noise");
  OutputDirectory output(arguments.value("output"),
                         {"office.pgm", "office.yaml", "rooms.png", "doors.csv"},
                         arguments.has("force"));
  StageMeter meter("generate");
  meter.begin("draw");
  const Office office = generateOffice(params);
  meter.begin("write");
  const MapGeometry& geometry = office.grid.geometry;
  saveMap(office.grid, output.stagedPath("office.yaml"));
  writePng(output.stagedPath("rooms.png"), labelImage(office.rooms, geometry));
  writeText(output.stagedPath("doors.csv"), segmentsCsv(office.doors_map, geometry));
  output.publish();
  meter.end();
  std::cout << arguments.value("output") << "/office.yaml: " << params.size << " x " << params.size
            << " pixels, " << office.doors_map.size() << " doors\n";
  return kDone;
}

}  // namespace

Command generateCommand() {
  Syntax syntax;
  syntax.command = "generate";
  syntax.summary = "Draws an office: office.yaml with its image, its true rooms and doors.";
  syntax.options = {
      {"output", 'o', "DIR", "directory to write to; made if missing", true},
      {"size", 0, "N", "pixels a side, 100..20000 (600)"},
      {"seed", 0, "S", "the same seed draws the same office (1)"},
      {"resolution", 0, "M", "metres a pixel, 0.02..0.2 (0.05)"},
      {"no-furniture", 0, "", "empty rooms"},
      {"no-noise", 0, "", "clean walls, nothing seen through windows"},
      {"force", 0, "", "replace files that exist"},
  };
  return {syntax, generate};
}

}  // namespace agrid::tools
