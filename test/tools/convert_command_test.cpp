// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "agrid/map/map_io.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"
#include "tools/commands.h"

namespace agrid::tools {
namespace {

using nlohmann::json;
using test::contentsOf;
using test::contentsOfFolder;
using test::TemporaryFolder;

/// Two rooms, left and right of a wall in columns 29 and 30, with a door in image rows 10 to 17.
OccupancyGrid twoRooms(const Pose2& map_from_image = {}) {
  std::vector<std::string> rows(50, "#" + std::string(58, '.') + "#");
  rows.front() = rows.back() = std::string(60, '#');
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (y < 10 || y > 17) rows[y][29] = rows[y][30] = '#';
  }
  return test::asciiGrid(rows, 0.1, map_from_image);
}

int convert(const TemporaryFolder& temp, const std::string& output,
            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"agrid_map_tool", "convert", temp / "map.yaml", "-o",
                                     temp / output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run(arguments);
  testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  return code;
}

std::vector<std::vector<double>> readCsv(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "x1,y1,x2,y2");
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field;
    rows.emplace_back();
    while (std::getline(fields, field, ',')) rows.back().push_back(std::stod(field));
  }
  return rows;
}

TEST(ConvertCommand, WritesEveryFileAndNoOther) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "out"), kDone);
  std::vector<std::string> names;
  for (const auto& [name, content] : contentsOfFolder(temp / "out")) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"areas.png", "doors.csv", "edges.png", "graph.json",
                                             "graph.png", "grid.png", "labels.png", "overview.png",
                                             "summary.json", "walls.png"}));
  EXPECT_EQ(contentsOfFolder(temp / "").size(), 3U) << "map.yaml, map.pgm and the output only";
  for (const std::string& name : names) {
    if (name.find(".png") == std::string::npos) continue;
    EXPECT_FALSE(cv::imread(temp / ("out/" + name), cv::IMREAD_UNCHANGED).empty()) << name;
  }
}

TEST(ConvertCommand, DoorsLieWhereTheImageHasThem) {
  // The same file content whatever the origin, turned ones included.
  for (const Pose2& origin : {Pose2{}, Pose2{{-3, 20}, 0}, Pose2{{4, 1}, 0.5}}) {
    const TemporaryFolder temp;
    saveMap(twoRooms(origin), temp / "map.yaml");
    ASSERT_EQ(convert(temp, "out"), kDone);
    const auto doors = readCsv(contentsOf(temp / "out/doors.csv"));
    ASSERT_EQ(doors.size(), 1U);
    ASSERT_EQ(doors[0].size(), 4U);
    EXPECT_NEAR((doors[0][0] + doors[0][2]) / 2, 29.5, 2);
    EXPECT_NEAR((doors[0][1] + doors[0][3]) / 2, 13.5, 2);
    EXPECT_NEAR(std::abs(doors[0][1] - doors[0][3]), 8, 2);
  }
}

TEST(ConvertCommand, LabelsAreTheImagesAndOnlyOnFreePixels) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "out"), kDone);
  const cv::Mat labels = cv::imread(temp / "out/labels.png", cv::IMREAD_UNCHANGED);
  const cv::Mat map = cv::imread(temp / "map.pgm", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_16UC1);
  ASSERT_EQ(labels.size(), map.size());
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const int label = labels.at<std::uint16_t>(y, x);
      EXPECT_TRUE(label == 0 || map.at<unsigned char>(y, x) == 254) << x << " " << y;
      EXPECT_LE(label, 2);
    }
  }
  const int left = labels.at<std::uint16_t>(30, 10);
  const int right = labels.at<std::uint16_t>(30, 50);
  EXPECT_NE(left, 0);
  EXPECT_NE(right, 0);
  EXPECT_NE(left, right);
}

TEST(ConvertCommand, GraphTellsAreasAndDoors) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "out"), kDone);
  const json graph = json::parse(contentsOf(temp / "out/graph.json"));
  EXPECT_EQ(graph["frame"], "map");
  EXPECT_EQ(graph["map"]["digest"], OccupancyMap(loadMap(temp / "map.yaml").grid).digest());
  ASSERT_EQ(graph["areas"].size(), 2U);
  for (const json& area : graph["areas"]) {
    EXPECT_FALSE(area["name"].get<std::string>().empty());
    EXPECT_NEAR(area["size"].get<double>(), 13.5, 1);  // 28 x 48 pixels of 0.01 m^2
    EXPECT_GE(area["outline"].size(), 4U);
  }
  ASSERT_EQ(graph["doors"].size(), 1U);
  const json& door = graph["doors"][0];
  EXPECT_EQ(door["kind"], "DOOR");
  EXPECT_NEAR(door["width"].get<double>(), 0.8, 0.25);
  EXPECT_NE(door["areas"][0], door["areas"][1]);
  const double y = (door["jambs"][0][1].get<double>() + door["jambs"][1][1].get<double>()) / 2;
  EXPECT_NEAR(y, 3.6, 0.2);  // metres, from the bottom
}

TEST(ConvertCommand, SummaryCountsAndMeasures) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "out"), kDone);
  const json summary = json::parse(contentsOf(temp / "out/summary.json"));
  EXPECT_EQ(summary["pixels"], 3000);
  EXPECT_EQ(summary["cells"].get<int>(),
            summary["rows"].get<int>() * summary["columns"].get<int>());
  EXPECT_EQ(summary["areas"], 2);
  EXPECT_EQ(summary["doors"], 1);
  for (const char* stage : {"load", "walls", "grid", "areas", "graph", "write"}) {
    EXPECT_GE(summary["stages"][stage]["seconds"].get<double>(), 0) << stage;
    EXPECT_GT(summary["stages"][stage]["peak_mb"].get<double>(), 0) << stage;
  }
  EXPECT_TRUE(summary["warnings"].is_array());
}

TEST(ConvertCommand, F27_M16_TimeAndPeakMemoryArePrinted) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  testing::internal::CaptureStdout();
  ASSERT_EQ(run({"agrid_map_tool", "convert", temp / "map.yaml", "-o", temp / "out"}), kDone);
  const std::string printed = testing::internal::GetCapturedStdout();
  const std::regex line(
      ".*/map\\.yaml: [0-9]+ cells, 2 areas, 1 doors, [0-9]+\\.[0-9] s, at most [0-9]+ MB\n");
  EXPECT_TRUE(std::regex_match(printed, line)) << printed;
}

TEST(ConvertCommand, TwoRunsWriteTheSameWithAnyNumberOfThreads) {
  const TemporaryFolder temp;
  testing::internal::CaptureStdout();
  ASSERT_EQ(run({"agrid_map_tool", "generate", "--size", "300", "--seed", "3", "-o", temp / "o"}),
            kDone);
  testing::internal::GetCapturedStdout();
  std::filesystem::rename(temp / "o/office.pgm", temp / "office.pgm");
  std::filesystem::rename(temp / "o/office.yaml", temp / "map.yaml");
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  ASSERT_EQ(convert(temp, "a"), kDone);
  cv::setNumThreads(4);
  ASSERT_EQ(convert(temp, "b"), kDone);
  cv::setNumThreads(threads);
  auto a = contentsOfFolder(temp / "a");
  auto b = contentsOfFolder(temp / "b");
  a.erase("summary.json");  // tells how long it took
  b.erase("summary.json");
  EXPECT_EQ(a, b);
}

TEST(ConvertCommand, F28_ExistingOutputNeedsForce) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "out"), kDone);
  std::ofstream(temp / "out/labels.png") << "mine";
  EXPECT_EQ(convert(temp, "out"), kWrongUsage);
  EXPECT_EQ(contentsOf(temp / "out/labels.png"), "mine");
  EXPECT_EQ(convert(temp, "out", {"--force"}), kDone);
  EXPECT_NE(contentsOf(temp / "out/labels.png"), "mine");
}

TEST(ConvertCommand, F28_FailureLeavesNothingBehind) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  EXPECT_EQ(convert(temp, "out", {"--param", "max_pixels=100"}), kFileFailed);
  EXPECT_EQ(convert(temp, "out", {"--param", "min_threshold=-4"}), kFailed);
  EXPECT_EQ(contentsOfFolder(temp / "").size(), 2U);
}

TEST(ConvertCommand, ParametersReachThePipeline) {
  const TemporaryFolder temp;
  saveMap(twoRooms(), temp / "map.yaml");
  ASSERT_EQ(convert(temp, "narrow", {"--param", "max_door_width=0.5"}), kDone);
  EXPECT_EQ(json::parse(contentsOf(temp / "narrow/graph.json"))["doors"][0]["kind"], "PASSAGE");
  ASSERT_EQ(convert(temp, "large", {"-p", "min_area_size=20", "-p", "canny_low=2"}), kDone);
  EXPECT_EQ(json::parse(contentsOf(temp / "large/summary.json"))["areas"], 1);
  const std::vector<std::string> paper{"--method", "paper", "-p", "passage_max_width=0.6"};
  ASSERT_EQ(convert(temp, "paper", paper), kDone);
  EXPECT_EQ(json::parse(contentsOf(temp / "paper/summary.json"))["areas"], 1) << "no passage";
}

}  // namespace
}  // namespace agrid::tools
