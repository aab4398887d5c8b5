// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/markers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "two_rooms.h"

namespace agrid_map_ros {
namespace {

using visualization_msgs::Marker;

visualization_msgs::MarkerArray markersOf(const agrid::SemanticMap& map) {
  std_msgs::Header header;
  header.frame_id = "world";
  return makeMarkers(map, header);
}

/// A grid of thin cells whose areas take turns, so that every cell is a rectangle of its own.
agrid::SemanticMap manyCells(int columns, int rows) {
  agrid::SemanticMap map = test::twoRooms();
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= columns; ++i) x.push_back(i * 0.01);
  for (int i = 0; i <= rows; ++i) y.push_back(i * 0.01);
  map.structure.grid = std::make_shared<const agrid::AGrid>(agrid::Pose2{}, x, y);
  map.area_map.cell_areas.clear();
  for (int i = 0; i < columns * rows; ++i) {
    map.area_map.cell_areas.push_back(agrid::AreaId{i % 2 == 0 ? 3U : 7U});
  }
  return map;
}

TEST(Markers, TheFirstOneDeletesAllFormerOnes) {
  const auto array = markersOf(test::twoRooms());
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, int{Marker::DELETEALL});
  for (std::size_t i = 1; i < array.markers.size(); ++i) {
    EXPECT_EQ(array.markers[i].action, int{Marker::ADD});
  }
}

TEST(Markers, EveryNamespaceIsThereInTheMapsFrame) {
  std::set<std::string> namespaces;
  const auto array = markersOf(test::twoRooms());
  for (const Marker& marker : array.markers) {
    EXPECT_EQ(marker.header.frame_id, "world");
    if (marker.action == Marker::ADD) namespaces.insert(marker.ns);
  }
  EXPECT_EQ(namespaces,
            (std::set<std::string>{"areas", "cells", "doors", "graph", "names", "objects"}));
}

TEST(Markers, NamespaceAndIdAreUniqueAndCountUp) {
  std::map<std::string, int> next;
  for (const Marker& marker : markersOf(manyCells(300, 100)).markers) {
    if (marker.action != Marker::ADD) continue;
    EXPECT_EQ(marker.id, next[marker.ns]++) << marker.ns;
  }
  EXPECT_GT(next["areas"], 1);
}

TEST(Markers, L11_ListsAreSplitBetweenWholeFigures) {
  std::size_t triangles = 0;
  for (const Marker& marker : markersOf(manyCells(300, 100)).markers) {
    EXPECT_LE(marker.points.size(), kMaxMarkerPoints);
    EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size());
    EXPECT_NE(marker.type, int{Marker::LINE_STRIP});
    const std::size_t corners = marker.type == Marker::TRIANGLE_LIST ? 3 : 2;
    EXPECT_TRUE(marker.type == Marker::SPHERE_LIST || marker.points.size() % corners == 0);
    if (marker.ns == "areas") triangles += marker.points.size() / 3;
  }
  EXPECT_EQ(triangles, 2U * 300 * 100);
}

TEST(Markers, EverythingIsFiniteAndOriented) {
  for (const Marker& marker : markersOf(test::twoRooms({{3, -2}, 0.5})).markers) {
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-9) << marker.ns;
    for (const auto& point : marker.points) {
      EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
    }
  }
}

TEST(Markers, DoorsAreBlueFromJambToJamb) {
  for (const Marker& marker : markersOf(test::twoRooms()).markers) {
    if (marker.ns != "doors") continue;
    ASSERT_EQ(marker.points.size(), 2U);
    EXPECT_EQ(marker.points[0].x, 4.5);
    EXPECT_EQ(marker.points[0].y, 2);
    EXPECT_EQ(marker.points[1].y, 3);
    EXPECT_GT(marker.colors[0].b, marker.colors[0].r);
    EXPECT_GT(marker.colors[0].b, marker.colors[0].g);
  }
}

TEST(Markers, GridLinesCoverTheGrid) {
  std::size_t points = 0;
  for (const Marker& marker : markersOf(test::twoRooms()).markers) {
    if (marker.ns == "cells") points += marker.points.size();
  }
  EXPECT_EQ(points, 2U * (5 + 4));
}

TEST(Markers, CellsSideBySideInOneAreaMakeOneRectangle) {
  std::size_t points = 0;
  for (const Marker& marker : markersOf(test::twoRooms()).markers) {
    if (marker.ns == "areas") points += marker.points.size();
  }
  EXPECT_EQ(points, 2U * 6);  // hall: two cells, kitchen: one
}

std::size_t pointsIn(const visualization_msgs::MarkerArray& array, const std::string& ns) {
  std::size_t points = 0;
  for (const Marker& marker : array.markers) {
    if (marker.ns == ns) points += marker.points.size();
  }
  return points;
}

TEST(Markers, ObjectsAreRedBoxesTurnedAsTheyAre) {
  agrid::SemanticMap map = test::twoRooms();
  map.knowledge.objects[0].pose_map = {{6, 2}, std::acos(-1.) / 2};
  map.knowledge.objects[0].size = {1, 0.5};
  double width = 0;
  double height = 0;
  for (const Marker& marker : markersOf(map).markers) {
    if (marker.ns != "objects") continue;
    for (std::size_t i = 0; i < marker.points.size(); ++i) {
      width = std::max(width, std::abs(marker.points[i].x - 6));
      height = std::max(height, std::abs(marker.points[i].y - 2));
      EXPECT_GT(marker.colors[i].r, 2 * marker.colors[i].b);
      EXPECT_GT(marker.colors[i].r, 2 * marker.colors[i].g);
    }
  }
  EXPECT_NEAR(width, 0.25, 1e-9);
  EXPECT_NEAR(height, 0.5, 1e-9);
}

TEST(Markers, WhatWaitsIsOrangeIfItLiesInTheMapsFrame) {
  agrid::SemanticMap map = test::twoRooms();
  agrid::AreaTag area;
  agrid::DoorTag door;
  door.width = 0.9;
  auto& pending = map.knowledge.pending;
  pending = {{area, "", "?"}, {door, "world", "?"}, {map.knowledge.objects[0], "", "?"}};
  EXPECT_EQ(pointsIn(markersOf(map), "pending"), 8U + 2 + 8);
  for (const Marker& marker : markersOf(map).markers) {
    if (marker.ns != "pending") continue;
    EXPECT_GT(marker.colors.at(0).r, marker.colors.at(0).g);
    EXPECT_GT(marker.colors.at(0).g, marker.colors.at(0).b);
  }
  pending[0].frame_id = pending[1].frame_id = "map_of_yesterday";
  EXPECT_EQ(pointsIn(markersOf(map), "pending"), 8U);
}

TEST(Markers, L11_ManyObjectsAndNoNumbersThatAreNone) {
  agrid::SemanticMap map = test::twoRooms();
  const agrid::ObjectTag fridge = map.knowledge.objects[0];
  map.knowledge.objects.assign(100000, fridge);
  map.knowledge.objects[7].pose_map.yaw = std::nan("");
  map.knowledge.objects[8].size.x() = INFINITY;
  map.knowledge.objects[9].pose_map.position.y() = std::nan("");
  map.knowledge.pending = {{map.knowledge.objects[9], "", "?"}};
  const auto array = markersOf(map);
  EXPECT_EQ(array.markers.front().action, int{Marker::DELETEALL});
  EXPECT_EQ(pointsIn(array, "objects"), (100000U - 3) * (6 + 8));
  EXPECT_EQ(pointsIn(array, "pending"), 0U);
  std::map<std::string, int> next;
  for (const Marker& marker : array.markers) {
    if (marker.action != Marker::ADD) continue;
    ASSERT_EQ(marker.id, next[marker.ns]++) << marker.ns;
    ASSERT_LE(marker.points.size(), kMaxMarkerPoints);
    ASSERT_TRUE(std::isfinite(marker.pose.position.x + marker.pose.position.y));
    for (const auto& point : marker.points) ASSERT_TRUE(std::isfinite(point.x + point.y));
  }
}

TEST(Markers, NamesStandAtTheAnchors) {
  std::map<std::string, double> names;
  for (const Marker& marker : markersOf(test::twoRooms()).markers) {
    if (marker.ns == "names") names[marker.text] = marker.pose.position.x;
  }
  EXPECT_EQ(names,
            (std::map<std::string, double>{{"fridge", 7.5}, {"hall", 2.5}, {"Kitchen", 6.5}}));
}

TEST(Markers, MapWithoutAreas) {
  agrid::SemanticMap map = test::twoRooms();
  map.area_map.areas.clear();
  map.area_map.doors.clear();
  map.graph.passages.clear();
  map.knowledge.objects.clear();
  std::fill(map.area_map.cell_areas.begin(), map.area_map.cell_areas.end(), agrid::AreaId{0});
  EXPECT_EQ(markersOf(map).markers.size(), 2U);  // delete all, grid lines
}

}  // namespace
}  // namespace agrid_map_ros
