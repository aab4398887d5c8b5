// SPDX-License-Identifier: BSD-3-Clause
#include "tools/truth_yaml.h"

#include <limits>

#include "exchange/place_files.h"
#include "exchange/yaml_list.h"

namespace agrid::tools {
namespace {

constexpr std::size_t kMaxRooms = std::numeric_limits<std::uint16_t>::max();

}  // namespace

std::vector<Polygon> readRoomPolygons(const std::string& path) {
  const YamlFile file(path);
  std::vector<Polygon> rooms;
  for (const YAML::Node& room : file.list()) {
    const YAML::Node corners = file.entry(room, "polygon");
    if (!corners.IsSequence() || corners.size() < 3) {
      file.fail(corners.Mark(), "polygon: needs three points or more");
    }
    Polygon& polygon = rooms.emplace_back();
    for (const YAML::Node& corner : corners) polygon.push_back(file.point(corner));
    if (rooms.size() > kMaxRooms) file.fail(room.Mark(), "more than 65535 rooms");
  }
  return rooms;
}

std::vector<Segment> readDoorCorners(const std::string& path) {
  std::vector<Segment> doors;
  for (const PlaceDoor& door : readPlaceDoors(path)) doors.push_back(door.jambs_map);
  return doors;
}

}  // namespace agrid::tools
