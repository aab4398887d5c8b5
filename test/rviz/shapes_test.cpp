// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "agrid_map_ros/markers.h"
#include "area_picture.h"
#include "graph_shapes.h"
#include "support/two_rooms.h"

namespace agrid_map_rviz {
namespace {

TEST(Shapes, AreasHaveTheColoursThatTheMarkersHave) {
  const agrid::SemanticMap map = agrid::test::twoRooms();
  const auto markers = agrid_map_ros::makeMarkers(map, {});
  std::size_t compared = 0;
  for (const auto& marker : markers.markers) {
    if (marker.ns != "areas") continue;
    for (std::size_t i = 0; i < marker.points.size(); i += 6) {
      // the middle of a rectangle of two triangles
      const agrid::Point2 middle((marker.points[i].x + marker.points[i + 2].x) / 2,
                                 (marker.points[i].y + marker.points[i + 2].y) / 2);
      const auto cell = map.grid().cellAt(middle);
      ASSERT_TRUE(cell);
      const auto index = static_cast<std::size_t>(map.grid().index(*cell));
      const Color color = areaColor(static_cast<std::uint32_t>(map.area_map.cell_areas[index]));
      EXPECT_FLOAT_EQ(marker.colors[i].r, color.r);
      EXPECT_FLOAT_EQ(marker.colors[i].g, color.g);
      EXPECT_FLOAT_EQ(marker.colors[i].b, color.b);
      ++compared;
    }
  }
  EXPECT_GT(compared, 0U);
}

agrid_map::AGrid unevenGrid() {
  agrid_map::AGrid grid;
  grid.x = {-1, 0, 2};
  grid.y = {5, 5.5, 6.5};
  grid.labels = {7, 0, 0, 9};
  return grid;
}

TEST(AreaPicture, PaintsEachTexelAsTheCellThatItLiesIn) {
  const AreaPicture picture = paintAreas(unevenGrid(), 0.5, 4096);
  ASSERT_EQ(picture.width, 6U);
  ASSERT_EQ(picture.height, 3U);
  for (std::uint32_t y = 0; y < 3; ++y) {
    for (std::uint32_t x = 0; x < 6; ++x) {
      const std::uint8_t* texel = picture.rgba.data() + 4 * (y * 6 + x);
      const std::uint32_t label = x < 2 && y < 1 ? 7 : x >= 2 && y >= 1 ? 9 : 0;
      EXPECT_EQ(texel[3], label == 0 ? 0 : 255) << x << ", " << y;
      const float red = label == 0 ? static_cast<float>(texel[0]) : 255 * areaColor(label).r;
      EXPECT_NEAR(texel[0], red, 1) << x << ", " << y;
    }
  }
  EXPECT_EQ(picture.left, -1);
  EXPECT_EQ(picture.high, 6.5);
}

TEST(AreaPicture, HasNoMoreTexelsASideThanItMay) {
  const AreaPicture picture = paintAreas(unevenGrid(), 1e-6, 64);
  EXPECT_EQ(picture.width, 64U);
  EXPECT_EQ(picture.height, 64U);
}

TEST(AreaPicture, ShowsNothingOfAMessageThatDoesNotFitItself) {
  agrid_map::AGrid grid = unevenGrid();
  grid.labels.pop_back();
  EXPECT_EQ(paintAreas(grid, 0.5, 64).width, 0U);
  grid = unevenGrid();
  grid.x[1] = 3;
  EXPECT_EQ(paintAreas(grid, 0.5, 64).width, 0U);
  grid = unevenGrid();
  grid.y[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(paintAreas(grid, 0.5, 64).width, 0U);
  EXPECT_EQ(paintAreas({}, 0.5, 64).width, 0U);
}

TEST(Shapes, DoorsTellTheirStateAndHowSureTheyAre) {
  agrid_map::TopologicalGraph graph;
  graph.doors.resize(3);
  for (auto& door : graph.doors) door.jambs[1].y = 1;
  graph.doors[0].confidence = graph.doors[1].confidence = 1;
  graph.doors[0].state = agrid_map::Door::CLOSED;
  graph.doors[1].state = agrid_map::Door::OPEN;
  const Mesh mesh = doorShapes(graph);
  ASSERT_EQ(mesh.triangles.size(), 18U);
  const Color closed = mesh.triangles[0].color;
  const Color open = mesh.triangles[6].color;
  const Color unsure = mesh.triangles[12].color;
  EXPECT_GT(closed.r, 2 * closed.g);
  EXPECT_GT(open.g, 2 * open.r);
  EXPECT_GT(unsure.b, 2 * unsure.r);
  EXPECT_LT(unsure.a, closed.a);
}

TEST(Shapes, WhatWaitsInAnotherFrameIsNotDrawn) {
  agrid_map::TopologicalGraph graph;
  graph.header.frame_id = "map";
  graph.pending.resize(2);
  graph.pending[0].header.frame_id = "odom";
  graph.pending[1].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(pendingShapes(graph).triangles.empty());
  graph.pending[0].header.frame_id = "";
  EXPECT_FALSE(pendingShapes(graph).triangles.empty());
}

}  // namespace
}  // namespace agrid_map_rviz
