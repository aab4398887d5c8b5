// SPDX-License-Identifier: BSD-3-Clause
#include "tools/truth_files.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "agrid/map/map_io.h"
#include "tools/arguments.h"
#include "tools/image_frame.h"
#include "tools/room_pictures.h"
#include "tools/truth_yaml.h"

namespace agrid::tools {
namespace {

using Labels = std::vector<std::uint16_t>;

/// Even-odd rule at the centres of free pixels; those that have a room keep it.
void fillPolygon(const Polygon& corners_px, std::uint16_t room, const OccupancyMap& map,
                 Labels& rooms) {
  const MapGeometry& geometry = map.geometry();
  for (int y = 0; y < geometry.height; ++y) {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < corners_px.size(); ++i) {
      const Point2& a = corners_px[i];
      const Point2& b = corners_px[(i + 1) % corners_px.size()];
      if ((a.y() <= y + 0.5) == (b.y() <= y + 0.5)) continue;
      const double share = (y + 0.5 - a.y()) / (b.y() - a.y());
      crossings.push_back(a.x() + share * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto column = [&](double x) {
        return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, geometry.width * 1.0)));
      };
      for (int x = column(crossings[i]); x < column(crossings[i + 1]); ++x) {
        std::uint16_t& label = rooms[geometry.index({x, y})];
        if (label == 0 && map.isFree({x, y})) label = room;
      }
    }
  }
}

Labels roomsOfPolygons(const std::vector<Polygon>& polygons_map, const OccupancyMap& map) {
  const MapGeometry& geometry = map.geometry();
  Labels rooms(geometry.pixelCount(), 0);
  const Pose2 image_from_map = inverse(geometry.map_from_image);
  std::uint16_t room = 0;
  for (const Polygon& polygon : polygons_map) {
    Polygon corners_px;
    for (const Point2& p : polygon) corners_px.push_back(image_from_map * p / geometry.resolution);
    fillPolygon(corners_px, ++room, map, rooms);
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
