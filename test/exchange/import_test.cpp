// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/exchange/import.h"

#include <filesystem>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "agrid/exchange/export.h"
#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "exchange/given_overlap.h"
#include "exchange/place_files.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

SemanticMap bareMap(const OccupancyGrid& grid) {
  return annotate(extractStructure(std::make_shared<const OccupancyMap>(grid), {}), {}, {});
}

/// 10 m x 5 m of free space with walls around, 0.1 m a pixel; a wall in the middle with a door of
/// 1 m if asked for.
OccupancyGrid hall(bool wall, const Pose2& map_from_image = {}) {
  std::vector<std::string> rows(52, "#" + std::string(100, '.') + "#");
  rows.front() = rows.back() = std::string(102, '#');
  for (std::size_t y = 0; wall && y < rows.size(); ++y) {
    if (y < 20 || y >= 30) rows[y][50] = rows[y][51] = '#';
  }
  return test::asciiGrid(rows, 0.1, map_from_image);
}

/// Left and right half as areas 'left' and 'right'.
GivenPlace halves(const MapGeometry& geometry) {
  GivenPlace place;
  place.areas = {{"left", "room", {{"floor", "2"}}}, {"right", "", {}}};
  for (std::size_t i = 0; i < geometry.pixelCount(); ++i) {
    place.labels.push_back(geometry.pixel(i).x < geometry.width / 2 ? 1 : 2);
  }
  return place;
}

const Area* areaNamed(const SemanticMap& map, const std::string& name) {
  for (const Area& area : map.area_map.areas) {
    if (area.name == name) return &area;
  }
  return nullptr;
}

TEST(Import, ABorderWithoutWallsBecomesADoorInAnyFrame) {
  for (const Pose2& origin : {Pose2{}, Pose2{{4, -2}, 0.6}}) {
    const SemanticMap bare = bareMap(hall(false, origin));
    ASSERT_EQ(bare.area_map.areas.size(), 1U);
    const FittedTags fitted = fitTags(bare, halves(bare.map().geometry()));
    EXPECT_GT(fitted.mean_iou, 0.97);
    EXPECT_TRUE(fitted.warnings.empty());
    ASSERT_EQ(fitted.knowledge.doors.size(), 1U);
    const Point2 middle = origin * Point2(5.1, 2.6);
    EXPECT_LT((fitted.knowledge.doors[0].pose_map.position - middle).norm(), 0.15);
    const SemanticMap map = annotate(bare.structure, fitted.knowledge, {});
    ASSERT_EQ(map.area_map.areas.size(), 2U);
    const Area* left = areaNamed(map, "left");
    ASSERT_NE(left, nullptr);
    EXPECT_EQ(left->category, "room");
    EXPECT_EQ(left->properties, (Properties{{"floor", "2"}}));
    EXPECT_EQ(left, areaAt(map, origin * Point2(2, 2.5)));
    EXPECT_EQ(areaNamed(map, "right"), areaAt(map, origin * Point2(8, 2.5)));
  }
}

TEST(Import, AnAreaDrawnOverADoorIsOne) {
  const SemanticMap bare = bareMap(hall(true));
  ASSERT_EQ(bare.area_map.areas.size(), 2U);
  GivenPlace place;
  place.areas = {{"flat", "", {}}};
  place.labels.assign(bare.map().geometry().pixelCount(), 1);
  const FittedTags fitted = fitTags(bare, place);
  ASSERT_EQ(fitted.knowledge.doors.size(), 1U);
  EXPECT_TRUE(fitted.knowledge.doors[0].absent);
  EXPECT_GT(fitted.mean_iou, 0.99);
  EXPECT_EQ(annotate(bare.structure, fitted.knowledge, {}).area_map.areas.size(), 1U);
}

TEST(Import, WhatIsFoundAnywayNeedsNoDoors) {
  const SemanticMap bare = bareMap(hall(true));
  const FittedTags fitted = fitTags(bare, halves(bare.map().geometry()));
  EXPECT_TRUE(fitted.knowledge.doors.empty());
  EXPECT_EQ(fitted.knowledge.areas.size(), 2U);
}

TEST(Import, DoorsAndObjectsAloneAreKept) {
  const SemanticMap bare = bareMap(hall(true));
  GivenPlace place;
  place.doors.push_back(tagOf(PlaceDoor{"d1", {{5.1, 2.1}, {5.1, 3.1}}}));
  place.doors.push_back(tagOf(PlaceDoor{"nowhere", {{50, 2.1}, {50, 3.1}}}));
  ObjectTag object;
  object.name = "desk";
  object.pose_map = {{2, 2}, 0.5};
  place.objects.push_back(object);
  const FittedTags fitted = fitTags(bare, place);
  ASSERT_EQ(fitted.knowledge.doors.size(), 2U) << "nothing that people gave is lost";
  EXPECT_EQ(fitted.warnings, (std::vector<std::string>{"door 'nowhere' parts no areas"}));
  ASSERT_EQ(fitted.knowledge.objects.size(), 1U);
  EXPECT_EQ(fitted.knowledge.objects[0].id, ObjectId{1});
  const SemanticMap map = annotate(bare.structure, fitted.knowledge, {});
  std::set<std::string> parting;
  for (const Door& door : map.area_map.doors) {
    if (door.areas[0] != door.areas[1]) parting.insert(door.name);
  }
  EXPECT_EQ(parting, std::set<std::string>{"d1"});
}

TEST(Import, SpecksAreNoAreas) {
  const SemanticMap bare = bareMap(hall(true));
  GivenPlace place = halves(bare.map().geometry());
  place.areas.resize(4);
  place.labels[bare.map().geometry().index({20, 20})] = 3;
  const FittedTags fitted = fitTags(bare, place);
  EXPECT_EQ(fitted.knowledge.areas.size(), 2U);
  ASSERT_EQ(fitted.warnings.size(), 1U);
  EXPECT_EQ(fitted.warnings[0].substr(0, 7), "2 areas");
}

TEST(Import, LabelsMustFitTheMap) {
  const SemanticMap bare = bareMap(hall(false));
  GivenPlace place = halves(bare.map().geometry());
  place.labels.pop_back();
  EXPECT_THROW(fitTags(bare, place), std::invalid_argument);
  place = halves(bare.map().geometry());
  place.areas.pop_back();
  EXPECT_THROW(fitTags(bare, place), std::invalid_argument);
}

TEST(Import, OfficesComeOutAsTheyWereDrawn) {
  for (const bool furnished : {false, true}) {
    OfficeParams params;
    params.size = 400;
    params.seed = 3;
    params.furniture = params.noise = furnished;
    const Office office = generateOffice(params);
    const SemanticMap bare = bareMap(office.grid);
    GivenPlace place;
    place.labels = office.rooms;
    place.areas.resize(*std::max_element(office.rooms.begin(), office.rooms.end()));
    const FittedTags fitted = fitTags(bare, place);
    EXPECT_GT(fitted.mean_iou, 0.97);
    const SemanticMap map = annotate(bare.structure, fitted.knowledge, {});
    std::vector<std::uint16_t> rooms = office.rooms;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (bare.map().pixels()[i] != Occupancy::kFree) rooms[i] = 0;
    }
    EXPECT_GT(GivenOverlap(rooms, map.area_map).meanIou(), 0.96) << "with the tags in place";
  }
}

TEST(Import, WhatWasExportedAsGeoJsonComesBack) {
  const test::TemporaryFolder folder;
  const SemanticMap bare = bareMap(hall(false, {{4, -2}, 0.6}));
  GivenPlace drawn = halves(bare.map().geometry());
  drawn.areas[1].name = "R&D \"x\" \\ \xC3\xA4";
  ObjectTag desk;
  desk.name = "desk";
  desk.category = "table";
  desk.pose_map = {{6, 2}, 0.25};
  desk.size = {1.5, 0.75};
  desk.height = 0.7;
  desk.properties = {{"owner", "nobody"}};
  drawn.objects.push_back(desk);
  const Knowledge known = fitTags(bare, drawn).knowledge;
  const SemanticMap map = annotate(bare.structure, known, {});
  folder.write("a.geojson", exportMap(map, ExportFormat::kGeoJson, {}).bytes);
  const GivenPlace read = readGeoJson(folder / "a.geojson", bare.map());
  EXPECT_EQ(read.labels, map.area_map.pixel_labels.vector()) << "pixel by pixel";
  const Knowledge again = fitTags(bare, read).knowledge;
  ASSERT_EQ(again.areas.size(), known.areas.size());
  for (std::size_t k = 0; k < known.areas.size(); ++k) {
    EXPECT_EQ(again.areas[k].name, known.areas[k].name);
    EXPECT_EQ(again.areas[k].properties, known.areas[k].properties);
  }
  ASSERT_EQ(again.objects.size(), 1U);
  EXPECT_EQ(again.objects[0].properties, desk.properties);
  EXPECT_NEAR(again.objects[0].pose_map.yaw, 0.25, 1e-7);
  EXPECT_NEAR(again.objects[0].size.x(), 1.5, 1e-3);
  ASSERT_EQ(again.doors.size(), known.doors.size());
  EXPECT_LT((again.doors[0].pose_map.position - known.doors[0].pose_map.position).norm(), 0.1);
}

TEST(Import, MapsOfUtexasKeepTheirNamesAndAreas) {
  for (const char* name : {"bwi_real_2", "bwi_sim_3ne"}) {
    const std::string folder = std::string(AGRID_SHARED) + "/maps/real/" + name + "/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const SemanticMap bare = bareMap(loadMap(folder + "map.yaml").grid);
    GivenPlace place;
    readLocations(folder + "locations.yaml", bare.map(), place);
    for (const PlaceDoor& door : readPlaceDoors(folder + "doors.yaml")) {
      place.doors.push_back(tagOf(door));
    }
    place.objects = readPlaceObjects(folder + "objects.yaml");
    const FittedTags fitted = fitTags(bare, place);
    EXPECT_GT(fitted.mean_iou, 0.94) << name;
    const SemanticMap map = annotate(bare.structure, fitted.knowledge, {});
    std::size_t named = 0;
    for (const GivenArea& area : place.areas) named += areaNamed(map, area.name) != nullptr;
    EXPECT_GE(named + 1, place.areas.size()) << name;
    EXPECT_EQ(named + map.knowledge.pending.size(), place.areas.size()) << "none is lost";
    std::set<std::string> doors;
    for (const Door& door : map.area_map.doors) doors.insert(door.name);
    std::size_t found = 0;
    for (const DoorTag& door : place.doors) found += doors.count(door.name);
    EXPECT_GE(found + 3, place.doors.size()) << name;
  }
}

}  // namespace
}  // namespace agrid
