// SPDX-License-Identifier: BSD-3-Clause
#include "areas/outline.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

cv::Mat1b shapeOf(const std::vector<std::string>& rows) {
  cv::Mat1b shape(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
  for (int y = 0; y < shape.rows; ++y) {
    const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(y)];
    for (int x = 0; x < shape.cols; ++x) shape(y, x) = row[static_cast<std::size_t>(x)] == '*';
  }
  return shape;
}

double signedArea(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

TEST(Outline, OfOnePixelIsItsSquare) {
  const Polygon outline = traceOutline(shapeOf({"...", ".*.", "..."}));
  ASSERT_EQ(outline.size(), 4U);
  EXPECT_DOUBLE_EQ(signedArea(outline), 1);
}

TEST(Outline, OfAThinCorridorKeepsItsArea) {
  const Polygon outline = traceOutline(shapeOf({"*......", "*......", "*******"}));
  EXPECT_DOUBLE_EQ(signedArea(outline), 9);
}

TEST(Outline, OfNothingIsEmpty) { EXPECT_TRUE(traceOutline(shapeOf({"..", ".."})).empty()); }

TEST(Outline, GoesAroundHolesAndTakesTheLargestPart) {
  const Polygon outline = traceOutline(shapeOf({
      "*....******",
      ".*...*....*",
      ".....*....*",
      ".....*....*",
      ".....*....*",
      ".....******",
  }));
  ASSERT_EQ(outline.size(), 4U);
  EXPECT_DOUBLE_EQ(signedArea(outline), 36);
}

TEST(Outline, KeepsTheCornersOfAnL) {
  const Polygon outline = traceOutline(shapeOf({
      "****......",
      "****......",
      "****......",
      "****......",
      "**********",
      "**********",
      "**********",
      "**********",
  }));
  ASSERT_EQ(outline.size(), 6U);
  EXPECT_DOUBLE_EQ(signedArea(outline), 4 * 8 + 4 * 6);
}

TEST(Outline, SmoothsStairsButStaysWithinAPixel) {
  cv::Mat1b shape(60, 60, std::uint8_t{0});
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) shape(y, x) = std::hypot(x - 30, y - 30) < 25 ? 1 : 0;
  }
  const Polygon outline = traceOutline(shape);
  EXPECT_LT(outline.size(), 40U);
  for (const Point2& corner : outline) EXPECT_NEAR((corner - Point2(30.5, 30.5)).norm(), 25, 1.5);
  EXPECT_NEAR(signedArea(outline), M_PI * 25 * 25, 60);
}

}  // namespace
}  // namespace agrid
