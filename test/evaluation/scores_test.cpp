// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/scores.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "agrid/areas/area_segmentation.h"
#include "support/ascii_map.h"

namespace agrid {
namespace {

using Labels = std::vector<std::uint16_t>;

/// A free map of columns of 12 pixels height; one character of `columns` names each one's label.
Labels columnLabels(const std::string& columns) {
  Labels labels;
  for (int y = 0; y < 12; ++y) {
    for (const char c : columns) labels.push_back(static_cast<std::uint16_t>(c - '0'));
  }
  return labels;
}

OccupancyMap freeMap(int width) {
  const std::string row(static_cast<std::size_t>(width), '.');
  return test::asciiMap(std::vector<std::string>(12, row), 0.1);
}

TEST(Scores, PerfectAreasScoreOne) {
  const Labels rooms = columnLabels("111111111111222222222222222");
  const Labels areas = columnLabels("222222222222111111111111111");
  const AreaScores scores = scoreAreas(freeMap(27), areas, rooms);
  EXPECT_DOUBLE_EQ(scores.iou_all, 1);
  EXPECT_DOUBLE_EQ(scores.f1_50, 1);
  EXPECT_DOUBLE_EQ(scores.mcc, 1);
  EXPECT_EQ(scores.areas, 2U);
  EXPECT_EQ(scores.rooms, 2U);
}

TEST(Scores, OneAreaOverTwoRoomsLosesTheSmallerOne) {
  const Labels rooms = columnLabels("11111111111122222222222222222222");
  const Labels areas = columnLabels("11111111111111111111111111111111");
  const AreaScores scores = scoreAreas(freeMap(32), areas, rooms);
  EXPECT_DOUBLE_EQ(scores.iou_all, 20. / 32 / 2);
  EXPECT_DOUBLE_EQ(scores.f1_50, 2. / 3);
  EXPECT_DOUBLE_EQ(scores.mcc, 0);
}

TEST(Scores, SmallAreasAndFurnitureDoNotCount) {
  Labels rooms = columnLabels("1111111111111111");
  Labels areas = columnLabels("1111111111111122");  // area 2 has 24 pixels
  const OccupancyMap map = test::asciiMap(std::vector<std::string>(12, "............####"), 0.1);
  const AreaScores scores = scoreAreas(map, areas, rooms);
  EXPECT_EQ(scores.areas, 1U);
  EXPECT_DOUBLE_EQ(scores.iou_all, 12. / 14);
}

TEST(Scores, RefuseLabelsOfAnotherSize) {
  EXPECT_THROW(scoreAreas(freeMap(4), Labels(3), Labels(48)), std::invalid_argument);
  EXPECT_THROW(scoreDoors(freeMap(4), {}, Labels(3)), std::invalid_argument);
}

TEST(Scores, DoorsAreFoundNearTheBorderOnceEach) {
  const Labels rooms = columnLabels("11111111111122222222222222222222");  // border at x = 1.2 m
  const OccupancyMap map = freeMap(32);
  const Segment on_border{{1.2, 0.2}, {1.2, 1.0}};
  const Segment close{{1.6, 0.2}, {1.6, 1.0}};
  const Segment far{{2.0, 0.2}, {2.0, 1.0}};
  EXPECT_DOUBLE_EQ(scoreDoors(map, {on_border}, rooms).recall, 1);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {close}, rooms).precision, 1);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {on_border, close}, rooms).precision, 0.5);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {far}, rooms).recall, 0);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {}, rooms).precision, 0);
}

/// Ten floor plans with rooms drawn by people; free is grey 250 and above.
class FloorPlans : public ::testing::Test {
 protected:
  struct Means {
    double iou_all = 0;
    double mcc = 0;
    double f1_50 = 0;
    double door_precision = 0;
    double door_recall = 0;
  };

  void SetUp() override {
    if (!std::ifstream(path("NLB.png"))) GTEST_SKIP() << "no floor plans at " << path("");
  }
  static std::string path(const std::string& file) {
    return std::string(AGRID_SHARED) + "/maps/bormann/" + file;
  }

  static OccupancyMap load(const std::string& name) {
    cv::Mat1b image = cv::imread(path(name + ".png"), cv::IMREAD_GRAYSCALE);
    cv::flip(image, image, 0);
    OccupancyGrid grid;
    grid.geometry = {image.cols, image.rows, 0.05, {}};
    for (const std::uint8_t grey : image) grid.values.push_back(grey >= 250 ? 0 : 100);
    return OccupancyMap(grid);
  }

  static Labels loadRooms(const std::string& name) {
    const cv::Mat1b image = cv::imread(path(name + "_gt_segmentation.png"), cv::IMREAD_GRAYSCALE);
    cv::Mat1i components;
    cv::connectedComponents(image > 250, components, 8, CV_32S);
    cv::flip(components, components, 0);
    return {components.begin(), components.end()};
  }

  static Means score(const std::string& variant, const AreaParams& params) {
    Means mean;
    for (const char* name : {"Freiburg79_scan", "NLB", "lab_c_scan", "lab_d_scan", "lab_intel",
                             "lab_ipa", "office_a", "office_c", "office_f", "office_h"}) {
      const OccupancyMap map = load(name + variant);
      const AGrid grid(map.geometry().map_from_image, {0, 100}, {0, 100});
      const AreaMap areas = segmentAreas(map, grid, proposeTags(map, {}, params), params);
      const Labels rooms = loadRooms(name);
      const AreaScores scores = scoreAreas(map, areas.pixel_labels, rooms);
      std::vector<Segment> doors;
      for (const Door& door : areas.doors) doors.push_back(door.jambs_map);
      const DoorScores door_scores = scoreDoors(load(name), doors, rooms);
      std::printf("%-16s %-10s areas %.4f %.4f %.4f doors %.4f %.4f\n", name, variant.c_str(),
                  scores.iou_all, scores.mcc, scores.f1_50, door_scores.precision,
                  door_scores.recall);
      mean.iou_all += scores.iou_all / 10;
      mean.mcc += scores.mcc / 10;
      mean.f1_50 += scores.f1_50 / 10;
      mean.door_precision += door_scores.precision / 10;
      mean.door_recall += door_scores.recall / 10;
    }
    std::printf("mean %.4f %.4f %.4f doors %.4f %.4f\n", mean.iou_all, mean.mcc, mean.f1_50,
                mean.door_precision, mean.door_recall);
    return mean;
  }
};

TEST_F(FloorPlans, PlainOnesScoreAsMeasured) {
  const Means mean = score("", {});
  EXPECT_GT(mean.iou_all, 0.89);
  EXPECT_GT(mean.mcc, 0.905);
  EXPECT_GT(mean.f1_50, 0.92);
  EXPECT_GT(mean.door_precision, 0.89);
  EXPECT_GT(mean.door_recall, 0.86);
}

TEST_F(FloorPlans, FurnishedOnesScoreAsMeasured) {
  const Means mean = score("_furnitures", {});
  EXPECT_GT(mean.iou_all, 0.855);
  EXPECT_GT(mean.mcc, 0.850);
  EXPECT_GT(mean.f1_50, 0.890);
  EXPECT_GT(mean.door_precision, 0.85);
  EXPECT_GT(mean.door_recall, 0.86);
}

TEST_F(FloorPlans, ThePapersMethodScoresAsMeasured) {
  AreaParams params;
  params.method = AreaMethod::kPaper;
  const Means mean = score("", params);
  EXPECT_GT(mean.iou_all, 0.68);
  EXPECT_GT(mean.door_precision, 0.98);
  EXPECT_GT(mean.door_recall, 0.69);
}

}  // namespace
}  // namespace agrid
