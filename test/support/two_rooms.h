// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "agrid/semantic_map.h"
#include "support/ascii_map.h"

namespace agrid::test {

/// Two rooms with a door between them, 1 m a pixel, made by hand: areas 3 'hall' (corridor) and 7
/// 'Kitchen' (alias 'cuisine'), door 5 'pass', object 9 'fridge' (appliance) in the kitchen.
inline SemanticMap twoRooms(const Pose2& map_from_image = {}) {
  SemanticMap map;
  auto metric = std::make_shared<const OccupancyMap>(asciiMap({"#########",  //
                                                               "#...#...#",  //
                                                               "#.......#",  //
                                                               "#...#...?",  //
                                                               "#########"},
                                                              1, map_from_image));
  map.structure.map = metric;
  map.structure.grid = std::make_shared<const AGrid>(
      map_from_image, std::vector<double>{0, 1, 4, 5, 9}, std::vector<double>{0, 1, 4, 5});
  AreaMap& areas = map.area_map;
  std::vector<std::uint16_t> labels;
  for (const Occupancy pixel : metric->pixels()) {
    const std::size_t column = labels.size() % 9;
    const bool free = pixel == Occupancy::kFree;
    labels.push_back(static_cast<std::uint16_t>(!free ? 0 : column <= 4 ? 1 : 2));
  }
  areas.pixel_labels = std::move(labels);
  const AreaId none{0};
  const AreaId hall{3};
  const AreaId kitchen{7};
  areas.cell_areas = {none, none, none, none, none, hall, hall, kitchen, none, none, none, none};
  areas.areas.resize(2);
  areas.areas[0].id = hall;
  areas.areas[0].name = "hall";
  areas.areas[0].category = "corridor";
  areas.areas[0].anchor_map = map_from_image * Point2(2.5, 2.5);
  areas.areas[0].outline_map = {{1, 1}, {4, 1}, {4, 4}, {1, 4}};
  areas.areas[0].size = 10;
  areas.areas[1].id = kitchen;
  areas.areas[1].name = "Kitchen";
  areas.areas[1].anchor_map = map_from_image * Point2(6.5, 2.5);
  areas.areas[1].size = 9;
  areas.areas[1].source = TagSource::kManual;
  areas.areas[1].properties = {{"alias", "cuisine, galley"}};
  areas.doors.resize(1);
  Door& door = areas.doors[0];
  door.id = DoorId{5};
  door.name = "pass";
  door.jambs_map = {map_from_image * Point2(4.5, 2), map_from_image * Point2(4.5, 3)};
  door.width = 1;
  door.areas = {hall, kitchen};
  door.confidence = 0.5;
  door.cells = {6};
  map.graph.passages = {{{0, 1}}, {{0, 0}}};
  ObjectTag fridge;
  fridge.id = ObjectId{9};
  fridge.name = "fridge";
  fridge.category = "appliance";
  fridge.pose_map = map_from_image * Pose2{{7.5, 3.5}, 0};
  fridge.size = {0.5, 0.6};
  fridge.height = 1.8;
  map.knowledge.objects.push_back(fridge);
  return map;
}

}  // namespace agrid::test
