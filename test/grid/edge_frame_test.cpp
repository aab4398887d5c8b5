// SPDX-License-Identifier: BSD-3-Clause
#include "grid/edge_frame.h"

#include <random>

#include <gtest/gtest.h>

#include "agrid/grid/wall_detection.h"
#include "support/floor_plan.h"
#include "support/generated_maps.h"

namespace agrid {
namespace {

using test::noise;

constexpr double kDegree = 3.14159265358979 / 180;

WallParams upright() {
  WallParams params;
  params.estimate_direction = false;
  return params;
}

TEST(EdgeFrame, TheGridFrameMovesWithTheMapsOrigin) {
  OccupancyGrid grid = noise(4, 90, 70, 0.02);
  const Walls at_zero = detectWalls(OccupancyMap(grid));
  grid.geometry.map_from_image = {Point2(-3, 7), 0.7};
  const Walls moved = detectWalls(OccupancyMap(grid));
  const Point2 p(1.5, 2.5);
  EXPECT_LT(
      (moved.map_from_grid * p - grid.geometry.map_from_image * (at_zero.map_from_grid * p)).norm(),
      1e-12);
  ASSERT_EQ(moved.vertical.size(), at_zero.vertical.size());
  for (std::size_t i = 0; i < moved.vertical.size(); ++i) {
    EXPECT_EQ(moved.vertical[i].offset, at_zero.vertical[i].offset);
  }
}

TEST(EdgeFrame, TheBoundingRectangleOfATurnedMapHoldsItsCorners) {
  WallParams params = upright();
  params.direction_deg = 30;
  OccupancyGrid grid = noise(4, 120, 70, 0.02);
  grid.geometry.map_from_image = {Point2(-3, 7), 0.7};
  const Walls walls = detectWalls(OccupancyMap(grid), params);
  EXPECT_NEAR(walls.map_from_grid.yaw, 0.7 + 30 * kDegree, 1e-12);
  Point2 lowest(1e9, 1e9);
  Point2 highest(-1e9, -1e9);
  for (const Point2& corner : {Point2(0, 0), Point2(6, 0), Point2(0, 3.5), Point2(6, 3.5)}) {
    const Point2 p = inverse(walls.map_from_grid) * (grid.geometry.map_from_image * corner);
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  EXPECT_LT(lowest.norm(), 1e-9);
  EXPECT_LT((highest - walls.extent).norm(), 1e-9);
}

TEST(EdgeFrame, AFixedDirectionCountsModuloARightAngle) {
  std::mt19937 random(3);
  const OccupancyMap map(test::drawPlan(test::randomFloorPlan(random), 0));
  WallParams params = upright();
  for (const double direction_deg : {0.0, 90.0, -90.0, 360.0}) {
    params.direction_deg = direction_deg;
    EXPECT_EQ(detectWalls(map, params).map_from_grid.yaw, 0);
  }
}

TEST(EdgeFrame, ALongMapThatCannotBeTurnedLiesAlongTheImageAndSaysSo) {
  WallParams params = upright();
  params.direction_deg = 45;
  const Walls walls = detectWalls(OccupancyMap(noise(2, 100000, 10, 0.1)), params);
  EXPECT_EQ(walls.map_from_grid.yaw, 0);
  EXPECT_DOUBLE_EQ(walls.extent.x(), 5000);
  ASSERT_FALSE(walls.warnings.empty());
  EXPECT_NE(walls.warnings[0].find("too long"), std::string::npos);
}

TEST(EdgeFrame, DirectionsFoldIntoTheRightAngleAroundZero) {
  EXPECT_EQ(foldDirection(180), 0);
  EXPECT_NEAR(foldDirection(45), 45 * kDegree, 1e-15);
  EXPECT_NEAR(foldDirection(-45), 45 * kDegree, 1e-15);
  EXPECT_NEAR(foldDirection(100), 10 * kDegree, 1e-15);
  EXPECT_NEAR(foldDirection(-50), 40 * kDegree, 1e-15);
}

TEST(EdgeFrame, ATurnedEdgePixelLandsWhereItsCentreLies) {
  cv::Mat edges = cv::Mat::zeros(60, 80, CV_8UC1);
  edges.at<std::uint8_t>(10, 70) = 255;
  const EdgeFrame frame = edgeFrame({80, 60, 0.05, Pose2{}}, 0.5);
  const cv::Mat turned = turnEdges(edges, frame);
  const Point2 p = inverse(frame.image_from_grid) * (Point2(70.5, 49.5) * 0.05) / 0.05;
  EXPECT_EQ(cv::countNonZero(turned), 1);
  EXPECT_EQ(turned.at<std::uint8_t>(static_cast<int>(frame.extent_px.y() - p.y()),
                                    static_cast<int>(p.x())),
            255);
}

TEST(EdgeFrame, SamplesAllPixelsOfASmallImageAndFewOfALargeOne) {
  const cv::Mat small = cv::Mat(30, 20, CV_8UC1, cv::Scalar(255));
  const std::vector<Point2> all = sampleEdges(small);
  EXPECT_EQ(all.size(), 600U);
  EXPECT_EQ(all.front(), Point2(0.5, 29.5));
  EXPECT_LE(sampleEdges(cv::Mat(1000, 1000, CV_8UC1, cv::Scalar(255))).size(), 20000U);
  EXPECT_TRUE(sampleEdges(cv::Mat::zeros(30, 20, CV_8UC1)).empty());
}

}  // namespace
}  // namespace agrid
