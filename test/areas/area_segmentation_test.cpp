// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_segmentation.h"

#include <gtest/gtest.h>

#include "support/ascii_map.h"

namespace agrid {
namespace {

/// A grid of square cells over a map, in the map frame.
AGrid squareGrid(const MapGeometry& geometry, double side) {
  std::vector<double> x{0};
  std::vector<double> y{0};
  while (x.back() < geometry.width * geometry.resolution) x.push_back(x.back() + side);
  while (y.back() < geometry.height * geometry.resolution) y.push_back(y.back() + side);
  return {geometry.map_from_image, x, y};
}

AreaMap segment(const OccupancyMap& map, std::vector<Tag> tags = {},
                const AreaParams& params = {}) {
  for (Tag& tag : proposeTags(map, tags, params)) tags.push_back(std::move(tag));
  return segmentAreas(map, squareGrid(map.geometry(), 1), tags, params);
}

TEST(AreaSegmentation, TwoRoomsAndADoorAreTwoAreasAndOneDoor) {
  const OccupancyMap map = test::asciiMap(
      {
          "#################",
          "#.......#.......#",
          "#.......#.......#",
          "#...............#",
          "#...............#",
          "#.......#.......#",
          "#.......#.......#",
          "#.......#.......#",
          "#################",
      },
      0.5);
  const AreaMap areas = segment(map);
  ASSERT_EQ(areas.areas.size(), 2U);
  ASSERT_EQ(areas.doors.size(), 1U);
  const Door& door = areas.doors[0];
  EXPECT_EQ(door.kind, DoorKind::kDoor);
  EXPECT_DOUBLE_EQ(door.width, 1);
  EXPECT_EQ(door.areas[0], AreaId{1});
  EXPECT_EQ(door.areas[1], AreaId{2});
  EXPECT_NEAR(door.jambs_map.midpoint().x(), 4.25, 1e-9);
  EXPECT_NEAR(door.jambs_map.midpoint().y(), 2.5, 1e-9);
}

}  // namespace
}  // namespace agrid
