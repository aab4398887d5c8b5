// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "agrid/semantic_map.h"
#include "areas/outline.h"

namespace agrid::test {

/// Outline of the pixels with a label, map frame.
inline Polygon outlineOf(const std::vector<std::uint16_t>& labels, std::uint16_t label,
                         const MapGeometry& geometry) {
  cv::Mat1b shape(geometry.height, geometry.width);
  std::transform(labels.begin(), labels.end(), shape.begin(),
                 [&](std::uint16_t l) { return static_cast<std::uint8_t>(l == label ? 1 : 0); });
  Polygon outline = traceOutline(shape);
  for (Point2& corner : outline) corner = geometry.map_from_image * (corner * geometry.resolution);
  return outline;
}

/// A map whose areas are drawn, so that it does not matter how areas are found: letters are areas,
/// 'a' the one with id 1 and so on as they occur in the alphabet; '#' is wall, '?' unknown, '.'
/// free but in no area; the first row is the top.
inline SemanticMap drawnAreas(const std::vector<std::string>& rows, double resolution = 0.5,
                              const Pose2& map_from_image = {}) {
  OccupancyGrid grid;
  grid.geometry = {static_cast<int>(rows.at(0).size()), static_cast<int>(rows.size()), resolution,
                   map_from_image};
  std::string letters;
  for (const std::string& row : rows) {
    for (const char c : row) {
      if (c >= 'a' && c <= 'z' && letters.find(c) == std::string::npos) letters += c;
    }
  }
  std::sort(letters.begin(), letters.end());
  std::vector<std::uint16_t> labels;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.values.push_back(static_cast<std::int8_t>(c == '#' ? 100 : c == '?' ? -1 : 0));
      labels.push_back(static_cast<std::uint16_t>(letters.find(c) + 1));  // npos + 1 is 0
    }
  }
  SemanticMap map;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const auto label = static_cast<std::uint16_t>(i + 1);
    Area area;
    area.id = AreaId{label};
    area.name = "area_" + std::to_string(label);
    const auto pixel = std::find(labels.begin(), labels.end(), label) - labels.begin();
    area.anchor_map = grid.geometry.center(grid.geometry.pixel(static_cast<std::size_t>(pixel)));
    area.outline_map = outlineOf(labels, label, grid.geometry);
    map.area_map.areas.push_back(area);
  }
  map.area_map.pixel_labels = labels;
  map.structure.map = std::make_shared<const OccupancyMap>(grid);
  return map;
}

/// A door between two areas of a map, from jamb to jamb [m].
inline void addDoor(SemanticMap& map, const Segment& jambs_map, AreaId a, AreaId b) {
  Door door;
  door.id = DoorId{static_cast<std::uint32_t>(map.area_map.doors.size() + 1)};
  door.name = "door_" + std::to_string(map.area_map.doors.size() + 1);
  door.jambs_map = jambs_map;
  door.width = jambs_map.length();
  door.areas = {a, b};
  map.area_map.doors.push_back(door);
}

}  // namespace agrid::test
