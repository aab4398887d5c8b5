// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/place_files.h"

#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

using test::TemporaryFolder;

OccupancyMap freeMap() {
  return test::asciiMap(std::vector<std::string>(10, std::string(20, '.')), 0.5);
}

/// The message of the FileError that reading ends with; empty if there is none.
template <typename Read>
std::string errorOf(Read read) {
  try {
    read();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(PlaceFiles, DoorsHaveTheirMiddleAndLeadAcross) {
  const TemporaryFolder folder;
  folder.write("doors.yaml",
               "- approach:\n  - {from: a, point: [1, 2, 3]}\n  door_corner_pt_1: [1.0, 2.0]\n"
               "  door_corner_pt_2: [1.0, 3.0]\n  name: d1\n"
               "- {door_corner_pt_1: [0, 0], door_corner_pt_2: [2, 0]}\n");
  const auto doors = readPlaceDoors(folder / "doors.yaml");
  ASSERT_EQ(doors.size(), 2U);
  const DoorTag tag = tagOf(doors[0]);
  EXPECT_EQ(tag.name, "d1");
  EXPECT_EQ(tag.pose_map.position, Point2(1, 2.5));
  EXPECT_NEAR(std::abs(std::cos(tag.pose_map.yaw)), 1, 1e-9);
  EXPECT_EQ(tag.width, 1);
  EXPECT_EQ(tagOf(doors[1]).name, "");
}

TEST(PlaceFiles, LocationsAreCountedFromTheTopOfThePicture) {
  const TemporaryFolder folder;
  folder.write("l.yaml",
               "data: l.pgm\nlocations: [top, other]\npolygons:\n"
               "- [0, 0, 4, 0, 4, 2, 0, 2, 0, 0]\n- [10, 5, 12, 5, 12, 10, 10, 10]\n");
  const OccupancyMap map = freeMap();
  GivenPlace place;
  readLocations(folder / "l.yaml", map, place);
  ASSERT_EQ(place.areas.size(), 2U);
  EXPECT_EQ(place.areas[0].name, "top");
  EXPECT_EQ(std::count(place.labels.begin(), place.labels.end(), 1), 8);
  EXPECT_EQ(place.labels[map.geometry().index({3, 9})], 1) << "the highest row";
  EXPECT_EQ(place.labels[map.geometry().index({3, 7})], 0);
  EXPECT_EQ(std::count(place.labels.begin(), place.labels.end(), 2), 10);
  EXPECT_EQ(place.labels[map.geometry().index({11, 0})], 2);
}

TEST(PlaceFiles, ObjectsHaveAPose) {
  const TemporaryFolder folder;
  folder.write("o.yaml", "- {name: desk, point: [1, 2, 0.5]}\n");
  const auto objects = readPlaceObjects(folder / "o.yaml");
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].pose_map.yaw, 0.5);
  EXPECT_EQ(objects[0].source, TagSource::kManual);
}

TEST(PlaceFiles, WhatIsWrongIsToldWithPathAndLine) {
  const TemporaryFolder folder;
  const auto doorsOf = [&](const std::string& text) {
    folder.write("f.yaml", text);
    return errorOf([&] { readPlaceDoors(folder / "f.yaml"); });
  };
  const std::string a = "- door_corner_pt_1: [0, 0]\n";
  const std::string path = folder / "f.yaml";
  EXPECT_EQ(doorsOf("{}"), path + ":1: is no list");
  EXPECT_EQ(doorsOf("- 3\n"), path + ":1: is nothing with a key 'door_corner_pt_1'");
  EXPECT_EQ(doorsOf(a), path + ":1: no key 'door_corner_pt_2'");
  EXPECT_EQ(doorsOf(a + "  door_corner_pt_2: [1, .nan]\n"),
            path + ":2: a point is [x, y], two finite numbers");
  EXPECT_EQ(doorsOf(a + "  door_corner_pt_2: [0, 0]\n"),
            path + ":1: both corners of the door are one");
  EXPECT_NE(doorsOf(a + "  door_corner_pt_2: [1, 0]\n  name: \"a\\nb\"\n").find(":3: the name"),
            std::string::npos);
  EXPECT_NE(doorsOf("- [").find(path + ":1: "), std::string::npos);
  EXPECT_NE(errorOf([&] { readPlaceDoors(folder / "none"); }).find("No such file"),
            std::string::npos);
}

TEST(PlaceFiles, LocationsNeedAPolygonEach) {
  const TemporaryFolder folder;
  const OccupancyMap map = freeMap();
  GivenPlace place;
  const auto locationsOf = [&](const std::string& text) {
    folder.write("f.yaml", text);
    return errorOf([&] { readLocations(folder / "f.yaml", map, place); });
  };
  const std::string path = folder / "f.yaml";
  EXPECT_EQ(locationsOf("- 1\n"), path + ":1: is nothing with a key 'locations'");
  EXPECT_EQ(locationsOf("locations: [a]\n"), path + ":1: no key 'polygons'");
  EXPECT_EQ(locationsOf("locations: [a]\npolygons: []\n"),
            path + ":2: polygons: there must be one for each of 'locations'");
  for (const char* bad : {"[0, 0, 1, 1]", "[0, 0, 1, 1, 2]", "7"}) {
    EXPECT_NE(
        locationsOf(std::string("locations: [a]\npolygons: [") + bad + "]\n").find(":2: poly"),
        std::string::npos);
  }
  EXPECT_EQ(locationsOf("locations: [a]\npolygons: [[0, 0, 1, 1, 2, .inf]]\n"),
            path + ":2: is no finite number");
  EXPECT_NE(locationsOf("locations: [\"\"]\npolygons: [[0, 0, 1, 1, 2, 2]]\n").find("name"),
            std::string::npos);
}

TEST(PlaceFiles, ForeignGeoJsonIsTakenByItsGeometry) {
  const TemporaryFolder folder;
  folder.write("f.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "den", "properties": {"beds": 2}},
     "geometry": {"type": "Polygon", "coordinates":
       [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}},
    {"type": "Feature", "properties": null,
     "geometry": {"type": "LineString", "coordinates": [[4, 1, 0], [4, 2, 0]]}},
    {"type": "Feature", "properties": {"name": "box", "kind": "object"},
     "geometry": {"type": "Polygon", "coordinates": [[[6, 1], [8, 1], [8, 2], [6, 2], [6, 1]]]}},
    {"type": "Feature", "properties": {"name": "spot"},
     "geometry": {"type": "Point", "coordinates": [7, 3]}}]})");
  const OccupancyMap map = freeMap();
  const GivenPlace place = readGeoJson(folder / "f.geojson", map);
  ASSERT_EQ(place.areas.size(), 1U);
  EXPECT_EQ(place.areas[0].properties, (Properties{{"beds", "2"}}));
  EXPECT_EQ(std::count(place.labels.begin(), place.labels.end(), 1), 64 - 4) << "without the hole";
  ASSERT_EQ(place.doors.size(), 1U);
  EXPECT_EQ(place.doors[0].width, 1);
  ASSERT_EQ(place.objects.size(), 2U);
  EXPECT_EQ(place.objects[0].size, Point2(2, 1));
  EXPECT_EQ(place.objects[1].pose_map.position, Point2(7, 3));
}

TEST(PlaceFiles, WrongGeoJsonIsToldWithItsFeature) {
  const TemporaryFolder folder;
  const OccupancyMap map = freeMap();
  const auto problemOf = [&](const std::string& text) {
    folder.write("f", text);
    const std::string error = errorOf([&] { readGeoJson(folder / "f", map); });
    const std::string path = folder / "f";
    return error.substr(0, path.size()) == path ? error.substr(path.size()) : "no path: " + error;
  };
  const auto featureProblem = [&](const std::string& feature) {
    return problemOf(R"({"features": [)" + feature + "]}");
  };
  EXPECT_EQ(problemOf("[]"), ": is no FeatureCollection");
  EXPECT_NE(problemOf("{\"features\": [1e999]}").find("overflow"), std::string::npos);
  EXPECT_NE(problemOf("{").find("parse"), std::string::npos);
  EXPECT_EQ(featureProblem("3"), ": features[0]: is no object");
  EXPECT_EQ(featureProblem("{}"), ": features[0], geometry: is missing");
  EXPECT_EQ(featureProblem(R"({"geometry": null})"), ": features[0], geometry: is no object");
  const std::string point = R"("geometry": {"type": "Point", "coordinates": [1, 2]})";
  EXPECT_EQ(featureProblem("{" + point + R"(, "properties": {"name": 7}})"),
            ": features[0], properties.name: is no text");
  EXPECT_EQ(featureProblem("{" + point + R"(, "properties": {"height": -1}})"),
            ": features[0], properties: a size below 0");
  EXPECT_EQ(featureProblem("{" + point + R"(, "properties": {"properties": {"a": [1]}}})"),
            ": features[0], properties.properties.a: is no text");
  EXPECT_EQ(featureProblem(R"({"geometry": {"type": "Point", "coordinates": [1, "x"]}})"),
            ": features[0], coordinates: is no finite number");
  EXPECT_EQ(featureProblem(R"({"geometry": {"type": "Polygon", "coordinates": [[[1, 2]]]}})"),
            ": features[0], coordinates: needs 4 points or more");
  EXPECT_EQ(
      featureProblem(R"({"geometry": {"type": "LineString", "coordinates": [[1, 2], [1, 2]]}})"),
      ": features[0], coordinates: both ends of the door are one");
  EXPECT_NE(featureProblem(R"({"geometry": {"type": "Curve"}})").find("geometry.type: 'Curve'"),
            std::string::npos);
}

}  // namespace
}  // namespace agrid
