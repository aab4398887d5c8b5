// SPDX-License-Identifier: BSD-3-Clause
#include "semantic_map/shape.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "agrid/semantic_map/object_area.h"
#include "support/two_rooms.h"

namespace agrid {
namespace {

constexpr int kSteps = 100;

/// A star-shaped polygon, a line or a point.
Shape randomShape(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-3, 3);
  std::uniform_real_distribution<double> radius(0.2, 2);
  const std::size_t count = 1 + random() % 7;
  const Point2 center(place(random), place(random));
  std::vector<Point2> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    corners.push_back(center + radius(random) * Point2(std::cos(angle), std::sin(angle)));
  }
  return Shape(corners);
}

/// Points close together all along a shape's outline.
std::vector<Point2> samplesOf(const Shape& shape) {
  std::vector<Point2> samples;
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const Point2 a = shape.corners[i];
    const Point2 b = shape.corners[(i + 1) % shape.corners.size()];
    for (int k = 0; k < kSteps; ++k) samples.push_back(a + (b - a) * k / kSteps);
  }
  return samples;
}

/// Whether a point is inside a polygon, by the sum of the angles it is seen under.
bool isInside(const Shape& shape, const Point2& point) {
  double turned = 0;
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const Point2 a = shape.corners[i] - point;
    const Point2 b = shape.corners[(i + 1) % shape.corners.size()] - point;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned) > 1;
}

TEST(Shape, DistancesAreThoseOfAllPoints) {
  std::mt19937 random(5);
  for (int i = 0; i < 150; ++i) {
    const Shape a = randomShape(random);
    const Shape b = randomShape(random);
    double least = 1e9;
    for (const Point2& p : samplesOf(a)) {
      if (b.corners.size() > 2 && isInside(b, p)) least = 0;
      for (const Point2& q : samplesOf(b)) least = std::min(least, (p - q).norm());
    }
    if (a.corners.size() > 2 && isInside(a, b.corners[0])) least = 0;
    EXPECT_NEAR(distanceBetween(a, b), least, 0.1) << i;
    EXPECT_LE(distanceBetween(a, b), least + 1e-12) << i;
    EXPECT_EQ(distanceBetween(a, b), distanceBetween(b, a)) << i;
    const double limited = distanceBetween(a, b, 1);
    EXPECT_TRUE(limited == distanceBetween(a, b) || (limited > 1 && distanceBetween(a, b) > 1));
  }
}

TEST(Shape, NearestPointsAreThoseOfAllPoints) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-4, 4);
  for (int i = 0; i < 500; ++i) {
    const Shape shape = randomShape(random);
    const Point2 point(place(random), place(random));
    const Point2 nearest = nearestPoint(shape, point);
    const bool inside = shape.corners.size() > 2 && isInside(shape, point);
    EXPECT_EQ(contains(shape, point), inside);
    EXPECT_EQ(nearest == point, inside);
    if (inside) continue;
    double least = 1e9;
    for (const Point2& p : samplesOf(shape)) least = std::min(least, (p - point).norm());
    EXPECT_NEAR((nearest - point).norm(), least, 0.05);
    EXPECT_LE((nearest - point).norm(), least + 1e-12);
  }
}

TEST(Shape, OfThings) {
  const SemanticMap map = test::twoRooms();
  EXPECT_EQ(shapeOf(&map.area_map.areas[0]).corners.size(), 4U);
  EXPECT_EQ(shapeOf(&map.area_map.areas[1]).corners, std::vector<Point2>{Point2(6.5, 2.5)});
  EXPECT_EQ(shapeOf(&map.area_map.doors[0]).corners, (std::vector<Point2>{{4.5, 2}, {4.5, 3}}));
  ObjectTag object = map.knowledge.objects[0];  // 0.5 by 0.6 at (7.5, 3.5)
  EXPECT_EQ(shapeOf(&object).low, Point2(7.25, 3.2));
  EXPECT_EQ(shapeOf(&object).high, Point2(7.75, 3.8));
  object.pose_map.yaw = M_PI / 2;
  EXPECT_TRUE(shapeOf(&object).low.isApprox(Point2(7.2, 3.25)));
  object.size = Point2::Zero();
  EXPECT_EQ(shapeOf(&object).corners, std::vector<Point2>{Point2(7.5, 3.5)});
}

TEST(ObjectArea, HoldsTheCenterOrGoesRoundIt) {
  SemanticMap map = test::twoRooms();
  ObjectTag object;
  object.pose_map.position = {1.5, 1.5};
  ASSERT_NE(areaOf(map, object), nullptr);
  EXPECT_EQ(areaOf(map, object)->name, "hall");
  std::vector<std::uint16_t> labels(map.area_map.pixel_labels.size(), 0);
  map.area_map.pixel_labels = std::move(labels);
  ASSERT_NE(areaOf(map, object), nullptr);
  EXPECT_EQ(areaOf(map, object)->name, "hall");
  map.area_map.areas[1].outline_map = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  map.area_map.areas[1].size = 1;
  EXPECT_EQ(areaOf(map, object)->name, "Kitchen");  // the smaller one
  object.pose_map.position = {20, 20};
  EXPECT_EQ(areaOf(map, object), nullptr);
}

}  // namespace
}  // namespace agrid
