// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/faces.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/ascii_map.h"
#include "support/two_rooms.h"

namespace agrid {
namespace {

cv::Mat1b shapeOf(const std::vector<std::string>& rows) {
  cv::Mat1b shape(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
  for (int y = 0; y < shape.rows; ++y) {
    for (int x = 0; x < shape.cols; ++x) {
      shape(y, x) =
          rows[rows.size() - 1 - static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '.';
    }
  }
  return shape;
}

double areaOf(const PixelRing& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const cv::Point& a = ring[i];
    const cv::Point& b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

/// Whether rings go around a pixel's centre an odd number of times.
bool holds(const std::vector<PixelRing>& rings, int x, int y) {
  bool inside = false;
  for (const PixelRing& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const cv::Point& a = ring[i];
      const cv::Point& b = ring[(i + 1) % ring.size()];
      if (a.x == b.x && a.x > x && std::min(a.y, b.y) <= y && y < std::max(a.y, b.y)) {
        inside = !inside;
      }
    }
  }
  return inside;
}

TEST(Faces, ARoomWithAPillarHasAHole) {
  const auto faces = facesOf(shapeOf({"#####",  //
                                      "#...#",  //
                                      "#.#.#",  //
                                      "#...#",  //
                                      "#####"}));
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].outer, (PixelRing{{4, 1}, {4, 4}, {1, 4}, {1, 1}}));
  ASSERT_EQ(faces[0].holes.size(), 1U);
  EXPECT_EQ(areaOf(faces[0].holes[0]), -1);
}

TEST(Faces, AHoleThatTouchesTheOutsideInACornerIsAHole) {
  // around the lower left '#' of the inner two there is a way by sides; the rings touch in a corner
  const auto faces = facesOf(shapeOf({"....",  //
                                      ".#..",  //
                                      "..#.",  //
                                      "...."}));
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].holes.size(), 2U);
  const auto pinched = facesOf(shapeOf({"#..",  //
                                        ".#.",  //
                                        "..."}));
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_EQ(pinched[0].holes.size(), 1U);
  EXPECT_EQ(areaOf(pinched[0].outer), 8);
}

TEST(Faces, PartsThatTouchInACornerAreTwo) {
  const auto faces = facesOf(shapeOf({"#.",  //
                                      ".#"}));
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].outer.size(), 4U);
  EXPECT_EQ(faces[1].outer.size(), 4U);
}

TEST(Faces, NothingHasNoFaces) {
  EXPECT_TRUE(facesOf(cv::Mat1b(3, 4, std::uint8_t{0})).empty());
  EXPECT_TRUE(facesOf(cv::Mat1b()).empty());
}

TEST(Faces, RingsHoldExactlyThePixelsOfTheirPart) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    cv::Mat1b shape(1 + static_cast<int>(random() % 12), 1 + static_cast<int>(random() % 12));
    const unsigned density = 2 + static_cast<unsigned>(random() % 8);
    for (std::uint8_t& pixel : shape) pixel = random() % 10 < density;
    cv::Mat1i parts;
    const int count = cv::connectedComponents(shape, parts, 4) - 1;
    const std::vector<Face> faces = facesOf(shape);
    ASSERT_EQ(faces.size(), static_cast<std::size_t>(count));
    for (const Face& face : faces) {
      std::vector<PixelRing> rings = face.holes;
      rings.push_back(face.outer);
      EXPECT_GT(areaOf(face.outer), 0);
      for (const PixelRing& hole : face.holes) EXPECT_LT(areaOf(hole), 0);
      std::set<int> held;
      for (int y = 0; y < shape.rows; ++y) {
        for (int x = 0; x < shape.cols; ++x) {
          if (holds(rings, x, y)) held.insert(parts(y, x));
        }
      }
      EXPECT_EQ(held.size(), 1U) << "one part, whole and alone";
      EXPECT_EQ(held.count(0), 0U);
      double size = 0;
      for (const PixelRing& ring : rings) {
        size += areaOf(ring);
        std::set<std::pair<int, int>> corners;
        for (const cv::Point& p : ring) EXPECT_TRUE(corners.emplace(p.x, p.y).second);
      }
      EXPECT_EQ(size, cv::countNonZero(parts == *held.begin()));
    }
  }
}

TEST(Faces, OfAreasLieInTheMapsFrame) {
  const Pose2 map_from_image{{10, -3}, 0.5};
  const SemanticMap map = test::twoRooms(map_from_image);
  const auto faces = areaFaces(map);
  ASSERT_EQ(faces.size(), 2U);
  ASSERT_EQ(faces[0].size(), 1U);
  EXPECT_EQ(areaOf(faces[0][0].outer), 10);
  const Polygon polygon = mapPolygon(faces[0][0].outer, map.map().geometry());
  bool has_corner = false;
  for (const Point2& corner : polygon) {
    has_corner = has_corner || (corner - map_from_image * Point2(1, 1)).norm() < 1e-9;
  }
  EXPECT_TRUE(has_corner);
}

}  // namespace
}  // namespace agrid
