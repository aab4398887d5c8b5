// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map.h"

#include <gtest/gtest.h>

#include "support/ascii_map.h"

namespace agrid {
namespace {

using Symbols = std::vector<std::string>;

/// Two rooms side by side, a cell each, and a door that lies in both cells.
SemanticMap twoRooms() {
  SemanticMap map;
  map.structure.map = std::make_shared<const OccupancyMap>(test::asciiMap({
      "#######",
      "#..#..#",
      "#.....#",
      "#######",
  }));
  map.structure.grid = std::make_shared<const AGrid>(Pose2{}, std::vector<double>{0, 3.5, 7},
                                                     std::vector<double>{0, 4});
  Area left;
  left.id = AreaId{4};
  left.name = "kitchen";
  left.category = "kitchen";
  Area right;
  right.id = AreaId{7};
  right.name = "hall";
  Door door;
  door.id = DoorId{2};
  door.name = "door_2";
  door.areas = {left.id, right.id};
  door.cells = {0, 1};
  map.area_map.areas = {left, right};
  map.area_map.doors = {door};
  std::vector<std::uint16_t> labels;
  for (const char c : std::string("0000000"
                                  "0111220"
                                  "0110220"
                                  "0000000")) {
    labels.push_back(static_cast<std::uint16_t>(c - '0'));
  }
  map.area_map.pixel_labels = std::move(labels);
  map.area_map.cell_areas = {left.id, right.id};
  return map;
}

TEST(SemanticMap, FindsAreasByIdAndByPoint) {
  const SemanticMap map = twoRooms();
  ASSERT_NE(findArea(map, AreaId{7}), nullptr);
  EXPECT_EQ(findArea(map, AreaId{7})->name, "hall");
  EXPECT_EQ(findArea(map, AreaId{1}), nullptr);
  EXPECT_EQ(findArea(map, AreaId{0}), nullptr);
  EXPECT_EQ(areaAt(map, {1.5, 1.5})->name, "kitchen");
  EXPECT_EQ(areaAt(map, {5.5, 2.5})->name, "hall");
  EXPECT_EQ(areaAt(map, {3.5, 2.5}), nullptr);
  EXPECT_EQ(areaAt(map, {-1, 2.5}), nullptr);
}

TEST(SemanticMap, ACellHoldsASetOfSymbols) {
  SemanticMap map = twoRooms();
  ObjectTag fridge;
  fridge.name = "fridge";
  fridge.pose_map.position = {1.5, 1.5};
  map.knowledge.objects.push_back(fridge);
  EXPECT_EQ(symbolsAt(map, {0, 0}), (Symbols{"door_2", "fridge", "kitchen"}));
  EXPECT_EQ(symbolsAt(map, {0, 1}), (Symbols{"door_2", "hall"}));
}

TEST(SemanticMap, ACellOutsideEveryAreaHasNoSymbols) {
  SemanticMap map = twoRooms();
  map.area_map.cell_areas[1] = AreaId{0};
  map.area_map.doors.clear();
  EXPECT_TRUE(symbolsAt(map, {0, 1}).empty());
}

}  // namespace
}  // namespace agrid
