// SPDX-License-Identifier: BSD-3-Clause
#include "tools/reports.h"

#include <cmath>

#include "exchange/json_text.h"

namespace agrid::tools {
namespace {

Json pose(const Pose2& p) {
  return {{"x", rounded(p.position.x())},
          {"y", rounded(p.position.y())},
          {"yaw", std::round(p.yaw * 1e8) / 1e8}};
}

std::uint32_t number(AreaId id) { return static_cast<std::uint32_t>(id); }

const char* stateName(DoorState state) {
  switch (state) {
    case DoorState::kOpen:
      return "OPEN";
    case DoorState::kClosed:
      return "CLOSED";
    case DoorState::kUnknown:
      break;
  }
  return "UNKNOWN";
}

Json areaJson(const Area& area) {
  Json outline = Json::array();
  for (const Point2& corner : area.outline_map) outline.push_back(jsonPoint(corner));
  return {{"id", number(area.id)},
          {"name", area.name},
          {"category", area.category},
          {"category_guess", area.category_guess},
          {"anchor", jsonPoint(area.anchor_map)},
          {"anchor_clearance", rounded(area.anchor_clearance)},
          {"size", rounded(area.size)},
          {"outline", outline}};
}

Json doorJson(const Door& door) {
  return {{"id", static_cast<std::uint32_t>(door.id)},
          {"name", door.name},
          {"kind", door.kind == DoorKind::kDoor ? "DOOR" : "PASSAGE"},
          {"jambs", {jsonPoint(door.jambs_map.a), jsonPoint(door.jambs_map.b)}},
          {"width", rounded(door.width)},
          {"areas", {number(door.areas[0]), number(door.areas[1])}},
          {"state", stateName(door.state)},
          {"confidence", rounded(door.confidence)}};
}

}  // namespace

std::string graphJson(const SemanticMap& map) {
  const MapGeometry& geometry = map.map().geometry();
  const Json about_map = {{"digest", map.map().digest()},
                          {"width", geometry.width},
                          {"height", geometry.height},
                          {"resolution", geometry.resolution},
                          {"map_from_image", pose(geometry.map_from_image)}};
  const Json about_grid = {{"rows", map.grid().rows()},
                           {"columns", map.grid().columns()},
                           {"map_from_grid", pose(map.grid().mapFromGrid())}};
  Json areas = Json::array();
  for (const Area& area : map.area_map.areas) areas.push_back(areaJson(area));
  Json doors = Json::array();
  for (const Door& door : map.area_map.doors) doors.push_back(doorJson(door));
  return "{\"format_version\": 1,\n \"frame\": \"map\",\n \"map\": " + jsonText(about_map) +
         ",\n \"grid\": " + jsonText(about_grid) + ",\n \"areas\": " + jsonLines(areas) +
         ",\n \"doors\": " + jsonLines(doors) + "}\n";
}

std::string summaryJson(const SemanticMap& map, const std::vector<StageCost>& costs,
                        const std::vector<std::string>& warnings) {
  Json json;
  json["format_version"] = 1;
  json["pixels"] = map.map().geometry().pixelCount();
  json["width"] = map.map().geometry().width;
  json["height"] = map.map().geometry().height;
  json["cells"] = map.grid().cellCount();
  json["rows"] = map.grid().rows();
  json["columns"] = map.grid().columns();
  json["areas"] = map.area_map.areas.size();
  json["doors"] = map.area_map.doors.size();
  double total = 0;
  for (const StageCost& cost : costs) {
    json["stages"][cost.stage] = {{"seconds", rounded(cost.seconds)},
                                  {"peak_mb", std::round(cost.peak_megabytes * 10) / 10}};
    total += cost.seconds;
  }
  json["seconds"] = rounded(total);
  json["warnings"] = warnings;
  return jsonText(json, 1) + "\n";
}

std::vector<Door> doorsBetweenAreas(const AreaMap& areas) {
  std::vector<Door> doors;
  for (const Door& door : areas.doors) {
    if (door.areas[0] != AreaId{0} && door.areas[1] != AreaId{0}) doors.push_back(door);
  }
  return doors;
}

std::vector<Segment> doorSegments(const AreaMap& areas) {
  std::vector<Segment> segments;
  for (const Door& door : doorsBetweenAreas(areas)) segments.push_back(door.jambs_map);
  return segments;
}

}  // namespace agrid::tools
