// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/exchange/export.h"

#include <clocale>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support/two_rooms.h"

namespace agrid {
namespace {

using nlohmann::json;

ExportParams straightWays(const std::string& frame_id = "map") {
  return {frame_id, [](const Point2& a, const Point2& b) { return std::vector<Point2>{a, b}; }};
}

json geoJson(const SemanticMap& map) {
  return json::parse(exportMap(map, ExportFormat::kGeoJson, straightWays()).bytes);
}

json featureOf(const json& collection, const std::string& id) {
  for (const json& feature : collection.at("features")) {
    if (feature.value("id", "") == id) return feature;
  }
  return {};
}

TEST(Export, TheEndingTellsTheFormat) {
  EXPECT_EQ(formatOfFile("monday.geojson"), ExportFormat::kGeoJson);
  EXPECT_EQ(formatOfFile("monday.nav2.geojson"), ExportFormat::kNav2);
  EXPECT_EQ(formatOfFile("a.labels.png"), ExportFormat::kLabels);
  EXPECT_EQ(formatOfFile("a.pl"), ExportFormat::kFacts);
  EXPECT_EQ(formatOfFile("a.yaml"), std::nullopt);
  EXPECT_EQ(formatOfFile("a.png"), std::nullopt);
  EXPECT_EQ(formatOfFile(".svg"), std::nullopt);
  EXPECT_EQ(formatOfFile(".nav2.geojson"), ExportFormat::kGeoJson) << "its stem is '.nav2'";
  EXPECT_EQ(formatOfFile(""), std::nullopt);
}

TEST(GeoJson, DoorsRunFromJambToJambInATurnedFrame) {
  const Pose2 map_from_image{{100, 50}, 0.7};
  const json door = featureOf(geoJson(test::twoRooms(map_from_image)), "door/5");
  const json line = door.at("geometry").at("coordinates");
  const Point2 a = map_from_image * Point2(4.5, 2);
  EXPECT_NEAR(line[0][0].get<double>(), a.x(), 1e-4);
  EXPECT_NEAR(line[0][1].get<double>(), a.y(), 1e-4);
  EXPECT_EQ(door.at("properties").at("width"), 1.0);
  EXPECT_EQ(door.at("properties").at("areas"), json({3, 7}));
  EXPECT_EQ(door.at("properties").at("state"), "unknown");
}

TEST(GeoJson, ADoorWithoutLengthIsAPoint) {
  SemanticMap map = test::twoRooms();
  map.area_map.doors[0].jambs_map.b = map.area_map.doors[0].jambs_map.a;
  EXPECT_EQ(featureOf(geoJson(map), "door/5").at("geometry").at("type"), "Point");
}

TEST(GeoJson, PropertiesOfPeopleStayApartFromOurs) {
  SemanticMap map = test::twoRooms();
  map.area_map.areas[1].properties["id"] = "mine";
  const json properties = featureOf(geoJson(map), "area/7").at("properties");
  EXPECT_EQ(properties.at("id"), 7);
  EXPECT_EQ(properties.at("properties").at("id"), "mine");
  EXPECT_EQ(properties.at("properties").at("alias"), "cuisine, galley");
}

TEST(GeoJson, ObjectsAreTheirTurnedBoxes) {
  SemanticMap map = test::twoRooms();
  ObjectTag& fridge = map.knowledge.objects[0];
  fridge.pose_map = {{6, 2}, 1.5707963267948966};
  fridge.size = {2, 1};
  const json box = featureOf(geoJson(map), "object/9").at("geometry").at("coordinates").at(0);
  ASSERT_EQ(box.size(), 5U) << "closed";
  EXPECT_EQ(box[0], json({6.5, 1.0}));
  EXPECT_EQ(box[0], box[4]);
  fridge.size = {2, 0};
  EXPECT_EQ(featureOf(geoJson(map), "object/9").at("geometry").at("type"), "Point");
}

TEST(GeoJson, NamesThatAreNoUtf8DoNotStopIt) {
  SemanticMap map = test::twoRooms();
  map.area_map.areas[0].name = "a\xFF\x01\"<&>";
  EXPECT_EQ(featureOf(geoJson(map), "area/3").at("properties").at("name"),
            "a\xEF\xBF\xBD\x01\"<&>");
}

TEST(Nav2, EveryIdIsUniqueAndEveryEdgeHasItsNodes) {
  const Exported exported = exportMap(test::twoRooms(), ExportFormat::kNav2, straightWays("floor"));
  const json graph = json::parse(exported.bytes);
  std::set<unsigned> ids;
  std::set<unsigned> nodes;
  for (const json& feature : graph.at("features")) {
    const json& properties = feature.at("properties");
    EXPECT_TRUE(ids.insert(properties.at("id").get<unsigned>()).second);
    if (feature.at("geometry").at("type") == "Point") {
      nodes.insert(properties.at("id").get<unsigned>());
      EXPECT_EQ(properties.at("frame"), "floor");
      continue;
    }
    EXPECT_TRUE(nodes.count(properties.at("startid").get<unsigned>()));
    EXPECT_TRUE(nodes.count(properties.at("endid").get<unsigned>()));
    EXPECT_TRUE(properties.at("overridable").get<bool>());
    EXPECT_EQ(properties.at("metadata").at("doors"), json({5}));
  }
  EXPECT_EQ(nodes.size(), 3U);
  EXPECT_EQ(ids.size(), 3U + 4U);
  EXPECT_TRUE(exported.warnings.empty());
}

TEST(Nav2, ClosedDoorsAreLeftOutAndTold) {
  SemanticMap map = test::twoRooms();
  map.area_map.doors[0].state = DoorState::kClosed;
  const Exported exported = exportMap(map, ExportFormat::kNav2, straightWays());
  EXPECT_EQ(json::parse(exported.bytes).at("features").size(), 2U);
  ASSERT_EQ(exported.warnings.size(), 2U);
  EXPECT_EQ(exported.warnings[0], "door 'pass' is closed");
}

TEST(Nav2, WithoutAWayFinderItIsRefused) {
  EXPECT_THROW(exportMap(test::twoRooms(), ExportFormat::kNav2, {}), std::invalid_argument);
}

TEST(Export, NothingDependsOnTheLocale) {
  SemanticMap map = test::twoRooms({{0.5, 0.25}, 0.1});
  map.area_map.areas[0].size = 1234567.5;
  std::vector<std::string> before;
  for (const ExportFormatName& format : kExportFormats) {
    before.push_back(exportMap(map, format.format, straightWays()).bytes);
  }
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no German locale";
  std::size_t i = 0;
  for (const ExportFormatName& format : kExportFormats) {
    EXPECT_EQ(exportMap(map, format.format, straightWays()).bytes, before[i++]) << format.name;
  }
  std::setlocale(LC_ALL, "C");
}

TEST(LabelsPng, HasTheMapsPixels) {
  const SemanticMap map = test::twoRooms();
  const std::string bytes = exportMap(map, ExportFormat::kLabels, {}).bytes;
  const cv::Mat image =
      cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.type(), CV_16UC1);
  ASSERT_EQ(image.size(), cv::Size(9, 5));
  EXPECT_EQ(image.at<std::uint16_t>(1, 1), 1);
  EXPECT_EQ(image.at<std::uint16_t>(3, 7), 2);
  EXPECT_EQ(image.at<std::uint16_t>(3, 8), 0);
}

TEST(Facts, QuoteWhatPrologReadsOtherwise) {
  SemanticMap map = test::twoRooms();
  map.area_map.areas[0].name = "it's a\\b\n";
  const std::string text = exportMap(map, ExportFormat::kFacts, {}).bytes;
  EXPECT_NE(text.find("area(3, 'it''s a\\\\b ').\n"), std::string::npos);
  EXPECT_NE(text.find("connects(5, 3, 7).\n"), std::string::npos);
  EXPECT_NE(text.find("in(9, 7).\n"), std::string::npos);
  EXPECT_NE(text.find("state(5, unknown).\n"), std::string::npos);
}

}  // namespace
}  // namespace agrid
