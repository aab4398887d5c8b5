// SPDX-License-Identifier: BSD-3-Clause
#include "tools/truth_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "agrid/map/map_io.h"
#include "exchange/polygon_labels.h"
#include "tools/arguments.h"
#include "tools/image_frame.h"
#include "tools/room_pictures.h"
#include "tools/truth_yaml.h"

namespace agrid::tools {
namespace {

using Labels = std::vector<std::uint16_t>;

Labels roomsOfPolygons(const std::vector<Polygon>& polygons_map, const OccupancyMap& map) {
  Labels rooms(map.geometry().pixelCount(), 0);
  std::uint16_t room = 0;
  for (const Polygon& polygon : polygons_map) {
    paintPolygon({pixelRing(polygon, map.geometry())}, ++room, map, rooms);
  }
  return rooms;
}

Segment doorOfLine(const std::string& line, const MapGeometry& geometry, const std::string& place) {
  std::vector<double> numbers;
  std::stringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');) {
    const auto number = parseNumber(field);
    if (!number) {
      throw FileError(FileErrorCode::kIo, place + ": '" + field + "' is no number");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != 4) throw FileError(FileErrorCode::kIo, place + ": needs x1,y1,x2,y2");
  return {mapPoint({numbers[0], numbers[1]}, geometry),
          mapPoint({numbers[2], numbers[3]}, geometry)};
}

std::vector<Segment> doorsOfCsv(const std::string& path, const MapGeometry& geometry) {
  std::ifstream file(path);
  if (!file) throw FileError(FileErrorCode::kPath, path + ": " + std::strerror(errno));
  std::vector<Segment> doors;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const bool header = number == 1 && line.rfind("x1,", 0) == 0;
    if (line.empty() || header) continue;
    doors.push_back(doorOfLine(line, geometry, path + ":" + std::to_string(number)));
  }
  return doors;
}

}  // namespace

std::vector<std::uint16_t> readTrueRooms(const std::string& path, const OccupancyMap& map) {
  const std::filesystem::path file(path);
  if (file.extension() == ".yaml") return roomsOfPolygons(readRoomPolygons(path), map);
  const MapGeometry& geometry = map.geometry();
  if (file.filename() == "rooms.png") return readNumberedRooms(path, geometry);
  if (file.filename() == "locations.png") return readLocations(path, geometry);
  return readPaintedRooms(path, geometry);
}

TrueDoors readTrueDoors(const std::string& path, const MapGeometry& geometry) {
  if (std::filesystem::path(path).extension() == ".csv") return {doorsOfCsv(path, geometry), true};
  return {readDoorCorners(path), false};
}

}  // namespace agrid::tools
