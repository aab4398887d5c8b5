// SPDX-License-Identifier: BSD-3-Clause
#include "tools/image_frame.h"

#include <cmath>

#include <gtest/gtest.h>

namespace agrid::tools {
namespace {

TEST(ImageFrame, PixelCentresLieAtIntegersFromTheTop) {
  const MapGeometry geometry{4, 3, 0.5, {{-1, 2}, 0}};
  const auto expectImagePoint = [&](Pixel pixel, double x, double y) {
    const Point2 point = imagePoint(geometry.center(pixel), geometry);
    EXPECT_NEAR(point.x(), x, 1e-9);
    EXPECT_NEAR(point.y(), y, 1e-9);
  };
  expectImagePoint({0, 0}, 0, 2);
  expectImagePoint({3, 2}, 3, 0);
}

TEST(ImageFrame, HonoursTheYawOfTheMap) {
  const MapGeometry geometry{10, 6, 0.1, {{5, -7}, 0.7}};
  const Point2 point = imagePoint(geometry.center({8, 1}), geometry);
  EXPECT_NEAR(point.x(), 8, 1e-9);
  EXPECT_NEAR(point.y(), 4, 1e-9);
}

TEST(ImageFrame, SegmentsAreLinesUnderAHeader) {
  const MapGeometry geometry{10, 10, 0.5, {}};
  const std::vector<Segment> segments{{{0.25, 0.25}, {1.25, 0.3}}};
  EXPECT_EQ(segmentsCsv(segments, geometry), "x1,y1,x2,y2\n0,9,2,8.9\n");
  EXPECT_EQ(segmentsCsv({}, geometry), "x1,y1,x2,y2\n");
}

TEST(ImageFrame, NumbersAreShort) {
  EXPECT_EQ(shortNumber(1.0), "1");
  EXPECT_EQ(shortNumber(-0.00001), "0");
  EXPECT_EQ(shortNumber(12345.67891), "12345.679");
}

}  // namespace
}  // namespace agrid::tools
