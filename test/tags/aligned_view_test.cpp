// SPDX-License-Identifier: BSD-3-Clause
#include "tags/aligned_view.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/drawn_plan.h"
#include "tags/basins.h"

namespace agrid {
namespace {

using test::DrawnPlan;

constexpr double kPi = 3.14159265358979323846;

double radians(double degrees) { return degrees * kPi / 180; }

/// Two rooms parted by a wall of 0.05 m.
DrawnPlan thinWall(double resolution, double degrees) {
  return DrawnPlan(8.05, 5).open({1, 1}, {4, 4}).open({4.05, 1}, {7.05, 4}).at(resolution, degrees);
}

OccupancyMap placed(const OccupancyMap& map, const Pose2& pose) {
  OccupancyGrid grid;
  grid.geometry = map.geometry();
  grid.geometry.map_from_image = pose;
  for (const Occupancy o : map.pixels()) grid.values.push_back(o == Occupancy::kFree ? 0 : 100);
  return OccupancyMap(grid);
}

/// Where a point of a plan lies on its map [m].
Point2 inMap(const DrawnPlan& plan, const OccupancyMap& map, const Point2& point) {
  return map.geometry().map_from_image * Point2(plan.inImage(point) * plan.resolution());
}

bool isFreeAt(const OccupancyMap& map, const Point2& point_map) {
  const auto pixel = map.geometry().pixelAt(point_map);
  return pixel && map.isFree(*pixel);
}

/// How many parts of more than ten pixels the free space has that hang together by their sides.
int roomsOf(const OccupancyMap& map) {
  cv::Mat1b space(map.geometry().height, map.geometry().width);
  std::transform(map.pixels().begin(), map.pixels().end(), space.begin(),
                 [](Occupancy o) { return o == Occupancy::kFree ? 1 : 0; });
  cv::Mat parts;
  cv::Mat1i stats;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(space, parts, stats, centers, 4, CV_32S);
  int rooms = 0;
  for (int i = 1; i < count; ++i) rooms += stats(i, cv::CC_STAT_AREA) > 10 ? 1 : 0;
  return rooms;
}

TEST(AlignedView, AnUprightMapAtFiveCentimetresIsItsOwn) {
  const OccupancyMap map = thinWall(0.05, 0).map();
  for (const double degrees : {0., 0.4, -0.4, 90., -90.2, 180.}) {
    const AlignedView view(map, {}, radians(degrees));
    EXPECT_TRUE(view.isMapItself()) << degrees;
    EXPECT_EQ(&view.map(), &map);
  }
  EXPECT_FALSE(AlignedView(map, {}, radians(0.6)).isMapItself());
}

TEST(AlignedView, TheOtherMethodsLookAtTheMapAsItIs) {
  const OccupancyMap map = thinWall(0.025, 0).map();
  AreaParams params;
  EXPECT_FALSE(AlignedView(map, params, radians(20)).isMapItself());
  for (const AreaMethod method : {AreaMethod::kPersistence, AreaMethod::kPaper}) {
    params.method = method;
    EXPECT_TRUE(AlignedView(map, params, radians(20)).isMapItself());
  }
}

TEST(AlignedView, AMapWithoutFreeSpaceIsItsOwn) {
  OccupancyGrid grid;
  grid.geometry = {4, 3, 0.025, Pose2{}};
  grid.values.assign(12, 100);
  const OccupancyMap map(grid);
  EXPECT_TRUE(AlignedView(map, {}, 0.3).isMapItself());
}

TEST(AlignedView, PointsAreFreeWhereTheyWereAndThinWallsStayWhole) {
  for (const double degrees : {0., 3., 7., -17., 30., 41., 45.}) {
    for (const double resolution : {0.025, 0.05}) {
      const DrawnPlan plan = thinWall(resolution, degrees);
      const Pose2 pose{{3, -2}, 0.4};
      const OccupancyMap map = placed(plan.map(), pose);
      const AlignedView view(map, {}, radians(degrees) + pose.yaw);
      if (degrees == 0 && resolution == 0.05) continue;
      ASSERT_FALSE(view.isMapItself());
      EXPECT_NEAR(view.geometry().resolution, 0.05, 1e-12);
      const double turn = view.geometry().map_from_image.yaw - pose.yaw - radians(degrees);
      EXPECT_NEAR(std::remainder(turn, kPi / 2), 0, 1e-9);
      for (double y = 1.1; y < 3.95; y += 0.03) {
        for (const double x : {1.1, 2., 3.9, 4.15, 6.9}) {
          EXPECT_TRUE(isFreeAt(view.map(), inMap(plan, map, {x, y}))) << degrees << ' ' << y;
        }
      }
      EXPECT_EQ(roomsOf(view.map()), 2) << degrees << " degrees, " << resolution << " m";
    }
  }
}

TEST(AlignedView, IsCutToWhatIsFreeWithARim) {
  const OccupancyMap map = thinWall(0.05, 30).map();
  const AlignedView view(map, {}, radians(30));
  const MapGeometry& geometry = view.geometry();
  EXPECT_NEAR(geometry.width, 6.05 / 0.05 + 4, 3);
  EXPECT_NEAR(geometry.height, 3 / 0.05 + 4, 3);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const bool at_rim = x == 0 || y == 0 || x == geometry.width - 1 || y == geometry.height - 1;
      if (at_rim) {
        EXPECT_FALSE(view.map().isFree({x, y}));
      }
    }
  }
}

TEST(AlignedView, PixelsAreFreeFromEightyPercentOn) {
  // squares of 4 by 4 pixels, of which 13, 12, 16 and 0 are free
  OccupancyGrid grid;
  grid.geometry = {16, 4, 0.0125, Pose2{}};
  grid.values.assign(64, 100);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 12; ++x) {
      const bool is_free = x >= 8 || y < 3 || x == 0;
      if (is_free) grid.values[grid.geometry.index({x, y})] = 0;
    }
  }
  const OccupancyMap map(grid);
  const AlignedView view(map, {}, 0);
  const auto freeAt = [&](double x) { return isFreeAt(view.map(), {x, 0.025}); };
  EXPECT_TRUE(freeAt(0.025));
  EXPECT_FALSE(freeAt(0.075));
  EXPECT_TRUE(freeAt(0.125));
  EXPECT_FALSE(freeAt(0.175));
}

TEST(AlignedView, LabelsComeBackToEveryFreePixelOfTheirRoom) {
  for (const double degrees : {7., 30., 45.}) {
    const DrawnPlan plan = thinWall(0.05, degrees);
    const OccupancyMap map = plan.map();
    const AlignedView view(map, {}, radians(degrees));
    const auto room = [&](const Point2& point_map) -> std::uint32_t {
      return (point_map - inMap(plan, map, {1, 1}))
                         .dot(inMap(plan, map, {2, 1}) - inMap(plan, map, {1, 1})) < 3.025
                 ? 0
                 : 1;
    };
    std::vector<std::uint32_t> labels(view.geometry().pixelCount(), Basins::kNone);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Pixel p = view.geometry().pixel(i);
      if (view.map().isFree(p)) labels[i] = room(view.geometry().center(p));
    }
    const auto on_map = view.labelsOnMap(labels);
    ASSERT_EQ(on_map.size(), map.pixels().size());
    for (std::size_t i = 0; i < on_map.size(); ++i) {
      const Pixel p = map.geometry().pixel(i);
      if (map.isFree(p)) {
        EXPECT_EQ(on_map[i], room(map.geometry().center(p))) << degrees;
      }
    }
  }
}

TEST(AlignedView, WhatIsNotConnectedToALabelGetsNone) {
  const DrawnPlan plan = thinWall(0.05, 30);
  const OccupancyMap map = plan.map();
  const AlignedView view(map, {}, radians(30));
  std::vector<std::uint32_t> labels(view.geometry().pixelCount(), Basins::kNone);
  const Point2 seed = inMap(plan, map, {2, 2});
  labels[view.geometry().index(view.geometry().pixelAt(seed).value())] = 5;
  const auto on_map = view.labelsOnMap(labels);
  const auto at = [&](const Point2& point) {
    return on_map[map.geometry().index(map.geometry().pixelAt(inMap(plan, map, point)).value())];
  };
  EXPECT_EQ(at({1.2, 3.8}), 5U);
  EXPECT_EQ(at({3.8, 1.2}), 5U);
  EXPECT_EQ(at({5, 2}), Basins::kNone);
  EXPECT_EQ(at({0.5, 0.5}), Basins::kNone);
}

TEST(AlignedView, TagsThatLieFreeOnTheMapLieFreeOnTheView) {
  const DrawnPlan plan = thinWall(0.05, 30);
  const OccupancyMap map = plan.map();
  const AlignedView view(map, {}, radians(30));
  std::vector<Tag> tags;
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    AreaTag area;
    area.seed_map = map.geometry().center(map.geometry().pixel(i));
    DoorTag door;
    door.pose_map.position = area.seed_map;
    door.pose_map.yaw = 1;
    tags.emplace_back(area);
    tags.emplace_back(door);
  }
  const auto moved = view.tagsOnView(tags);
  int count = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const bool is_area = i % 2 == 0;
    const auto placeOf = [&](const Tag& tag) {
      return is_area ? std::get<AreaTag>(tag).seed_map : std::get<DoorTag>(tag).pose_map.position;
    };
    const Point2 from = placeOf(tags[i]);
    const Point2 to = placeOf(moved[i]);
    const bool stays = !isFreeAt(map, from) || isFreeAt(view.map(), from);
    if (stays) {
      EXPECT_EQ(to, from);
      continue;
    }
    ++count;
    EXPECT_TRUE(isFreeAt(view.map(), to));
    EXPECT_LT((to - from).norm(), 0.1);
  }
  EXPECT_GT(count, 20) << "otherwise this shows nothing";
}

}  // namespace
}  // namespace agrid
