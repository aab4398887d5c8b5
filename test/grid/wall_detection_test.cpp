// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/wall_detection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "grid/edge_image.h"
#include "support/ascii_map.h"
#include "support/floor_plan.h"
#include "support/generated_maps.h"

namespace agrid {
namespace {

using test::noise;
using test::uniform;

constexpr double kDegree = 3.14159265358979 / 180;

WallParams upright() {
  WallParams params;
  params.estimate_direction = false;
  return params;
}

OccupancyMap randomPlanMap(unsigned seed, double turn_deg = 0) {
  std::mt19937 random(seed);
  return OccupancyMap(test::drawPlan(test::randomFloorPlan(random), turn_deg));
}

/// Alg. 1 as it is printed: the transform in every round, every line seen so far against every
/// line taken. Offsets of the lines from the left or top edge, in pixels.
std::vector<double> printedAlgorithm(const cv::Mat& edges, const WallParams& params,
                                     bool is_vertical) {
  std::vector<double> walls{0.0, static_cast<double>(is_vertical ? edges.cols : edges.rows)};
  std::vector<double> detected;
  for (int threshold = params.max_threshold_votes; threshold > params.min_threshold_votes;
       threshold -= params.threshold_step_votes) {
    const double min_distance = std::max(
        static_cast<double>(params.max_threshold_votes) / threshold, params.min_line_distance_px);
    std::vector<cv::Vec2f> lines;
    const double angle = is_vertical ? 0 : CV_PI / 2;
    cv::HoughLines(edges, lines, 2, CV_PI / 2, threshold, 0, 0, angle, angle + 1);
    // OpenCV's distances are one pixel short at this resolution; see the next test.
    for (const cv::Vec2f& line : lines) detected.push_back(line[0] + 1.5);
    for (const double d : detected) {
      const bool is_far = std::all_of(walls.begin(), walls.end(),
                                      [&](double w) { return std::abs(d - w) >= min_distance; });
      if (is_far) walls.push_back(d);
    }
  }
  std::sort(walls.begin(), walls.end());
  return {walls.begin() + 1, walls.end() - 1};
}

void expectOffsets(const std::vector<WallLine>& lines, const std::vector<double>& expected) {
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_NEAR(lines[i].offset, expected[i], 1e-9);
}

void expectPrintedAlgorithm(const OccupancyMap& map, const WallParams& params) {
  const cv::Mat edges = detectEdges(map, params);
  const Walls walls = detectWalls(map, params);
  std::vector<double> x = printedAlgorithm(edges, params, true);
  for (double& offset : x) offset *= 0.05;
  std::vector<double> y = printedAlgorithm(edges, params, false);
  for (double& offset : y) offset = (edges.rows - offset) * 0.05;
  std::reverse(y.begin(), y.end());
  expectOffsets(walls.vertical, x);
  expectOffsets(walls.horizontal, y);
}

TEST(WallDetection, EqualsThePrintedAlgorithm) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    WallParams params = upright();
    params.max_threshold_votes = 100 + 50 * static_cast<int>(seed % 7);
    params.min_threshold_votes = 5 * static_cast<int>(seed % 5);
    params.threshold_step_votes = 1 + 3 * static_cast<int>(seed % 4);
    params.min_line_distance_px = 3 + seed % 6;
    expectPrintedAlgorithm(randomPlanMap(seed), params);
    expectPrintedAlgorithm(OccupancyMap(noise(seed, 150, 110, 0.1 * (seed % 4))), params);
  }
}

/// Edge pixels whose centre lies within one pixel of a line of the upright image.
int countNear(const cv::Mat& edges, double line_px, bool is_vertical) {
  int count = 0;
  for (int row = 0; row < edges.rows; ++row) {
    for (int column = 0; column < edges.cols; ++column) {
      if (edges.at<std::uint8_t>(row, column) == 0) continue;
      const double center = is_vertical ? column + 0.5 : edges.rows - row - 0.5;
      count += std::abs(center - line_px) <= 1 + 1e-9 ? 1 : 0;
    }
  }
  return count;
}

TEST(WallDetection, TheEdgePixelsThatVotedLieWithinOnePixelOfTheLine) {
  for (unsigned seed = 60; seed < 66; ++seed) {
    std::mt19937 random(seed);
    test::FloorPlan plan = test::randomFloorPlan(random);
    plan.size.x() += seed % 2;  // even and odd image sizes
    const OccupancyMap map(test::drawPlan(plan, 0));
    const Walls walls = detectWalls(map, upright());
    const cv::Mat edges = detectEdges(map, upright());
    EXPECT_GT(walls.vertical.size() * walls.horizontal.size(), 16U);
    for (const WallLine& line : walls.vertical) {
      EXPECT_GE(countNear(edges, line.offset / 0.05, true), line.votes);
    }
    for (const WallLine& line : walls.horizontal) {
      EXPECT_GE(countNear(edges, line.offset / 0.05, false), line.votes);
    }
  }
}

TEST(WallDetection, WallsOfOneDirectionDoNotHideThoseOfTheOther) {
  OccupancyGrid cross = uniform(200, 120, 0);
  for (int y = 0; y < 120; ++y) cross.values[cross.geometry.index({60, y})] = 100;
  for (int x = 0; x < 200; ++x) cross.values[cross.geometry.index({x, 119 - 60})] = 100;
  const Walls walls = detectWalls(OccupancyMap(cross));
  EXPECT_EQ(walls.vertical.size(), 1U);
  EXPECT_EQ(walls.horizontal.size(), 1U);
}

TEST(WallDetection, FindsTheWallsOfADrawnRoomAtTheirPlace) {
  OccupancyGrid room = uniform(100, 80, 0);
  for (int y = 0; y < 80; ++y) room.values[room.geometry.index({30, y})] = 100;
  for (int x = 0; x < 100; ++x) room.values[room.geometry.index({x, 60})] = 100;
  const Walls walls = detectWalls(OccupancyMap(room));
  ASSERT_FALSE(walls.vertical.empty());
  ASSERT_FALSE(walls.horizontal.empty());
  EXPECT_NEAR(walls.vertical[0].offset, 30.5 * 0.05, 2.01 * 0.05);
  EXPECT_NEAR(walls.horizontal[0].offset, 60.5 * 0.05, 2.01 * 0.05);
  EXPECT_DOUBLE_EQ(walls.extent.x(), 5);
  EXPECT_DOUBLE_EQ(walls.extent.y(), 4);
  EXPECT_TRUE(walls.warnings.empty());
}

TEST(WallDetection, LinesKeepTheirDistanceFromEachOtherAndFromTheEdges) {
  for (unsigned seed = 20; seed < 30; ++seed) {
    const Walls walls = detectWalls(randomPlanMap(seed, 7.0 * seed));
    double before = 0;
    for (const WallLine& line : walls.vertical) {
      EXPECT_GE(line.offset - before, 5 * 0.05 - 1e-9);
      before = line.offset;
    }
    EXPECT_GE(walls.extent.x() - before, 5 * 0.05 - 1e-9);
  }
}

/// Lines with the votes of a whole wall; the ends of other walls add up to less.
int countStrong(const std::vector<WallLine>& lines) {
  return static_cast<int>(std::count_if(lines.begin(), lines.end(),
                                        [](const WallLine& line) { return line.votes > 80; }));
}

TEST(WallDetection, ATurnedBuildingKeepsItsWalls) {
  for (unsigned seed = 40; seed < 46; ++seed) {
    const Walls straight = detectWalls(randomPlanMap(seed));
    EXPECT_EQ(straight.map_from_grid.yaw, 0);
    for (const double turn_deg : {17.0, 30.0, 44.0, -20.0}) {
      SCOPED_TRACE(turn_deg);
      const Walls turned = detectWalls(randomPlanMap(seed, turn_deg));
      EXPECT_NEAR(turned.map_from_grid.yaw / kDegree, turn_deg, 0.3);
      EXPECT_NEAR(countStrong(turned.vertical), countStrong(straight.vertical), 1);
      EXPECT_NEAR(countStrong(turned.horizontal), countStrong(straight.horizontal), 1);
    }
  }
}

TEST(WallDetection, TheSameMapGivesTheSameWallsWithAnyNumberOfThreads) {
  const Walls a = detectWalls(randomPlanMap(5, 25));
  const int threads = cv::getNumThreads();
  cv::setNumThreads(threads == 1 ? 4 : 1);
  const Walls b = detectWalls(randomPlanMap(5, 25));
  cv::setNumThreads(threads);
  ASSERT_EQ(a.vertical.size(), b.vertical.size());
  for (std::size_t i = 0; i < a.vertical.size(); ++i) {
    EXPECT_EQ(a.vertical[i].offset, b.vertical[i].offset);
    EXPECT_EQ(a.vertical[i].votes, b.vertical[i].votes);
  }
  EXPECT_EQ(a.map_from_grid.yaw, b.map_from_grid.yaw);
}

TEST(WallDetection, M4_MapsOfOnePixelOrOneRowHaveNoWallsAndSaySo) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 50), std::pair(50, 1)}) {
    for (const int value : {-1, 0, 100}) {
      const Walls walls =
          detectWalls(OccupancyMap(uniform(width, height, static_cast<std::int8_t>(value))));
      EXPECT_TRUE(walls.vertical.empty());
      EXPECT_TRUE(walls.horizontal.empty());
      EXPECT_EQ(walls.warnings.size(), 1U);
      EXPECT_DOUBLE_EQ(walls.extent.x(), width * 0.05);
    }
    EXPECT_NO_THROW(detectWalls(OccupancyMap(noise(1, width, height, 0.5))));
  }
}

TEST(WallDetection, M14_UniformMapsHaveNoWallsAndSaySo) {
  for (const int value : {-1, 0, 100}) {
    const Walls walls =
        detectWalls(OccupancyMap(uniform(300, 200, static_cast<std::int8_t>(value))));
    EXPECT_TRUE(walls.vertical.empty() && walls.horizontal.empty());
    EXPECT_EQ(walls.warnings.size(), 1U);
  }
}

TEST(WallDetection, M15_NoiseGivesNoMoreLinesThanTheDistanceAllows) {
  for (const double density : {0.01, 0.1, 0.3, 0.5}) {
    const Walls walls = detectWalls(OccupancyMap(noise(8, 1000, 1000, density)));
    EXPECT_EQ(walls.map_from_grid.yaw, 0);
    EXPECT_LE(walls.vertical.size(), 200U);
    EXPECT_LE(walls.horizontal.size(), 200U);
  }
}

TEST(WallDetection, RefusesParametersOutOfRangeByName) {
  const OccupancyMap map = test::asciiMap({"..."});
  const auto message = [&](const WallParams& params) -> std::string {
    try {
      detectWalls(map, params);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WallParams params;
  params.canny_low = 40;
  EXPECT_NE(message(params).find("canny_low"), std::string::npos);
  params = {};
  params.max_threshold_votes = 20;
  EXPECT_NE(message(params).find("max_threshold_votes"), std::string::npos);
  params = {};
  params.min_threshold_votes = -1;
  EXPECT_NE(message(params).find("min_threshold_votes"), std::string::npos);
  params = {};
  params.threshold_step_votes = 0;
  EXPECT_NE(message(params).find("threshold_step_votes"), std::string::npos);
  params = {};
  params.min_line_distance_px = nan;
  EXPECT_NE(message(params).find("min_line_distance_px"), std::string::npos);
  params = {};
  params.distance_resolution_px = 0;
  EXPECT_NE(message(params).find("distance_resolution_px"), std::string::npos);
  params = {};
  params.direction_deg = nan;
  EXPECT_NE(message(params).find("direction_deg"), std::string::npos);
}

}  // namespace
}  // namespace agrid
