// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/narrow_place.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "tags/door_barrier.h"
#include "tags/free_space.h"

namespace agrid {
namespace {

double angleBetween(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); }

Point2 randomPoint(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> offset(-reach, reach);
  const double x = offset(random);
  return {x, offset(random)};
}

/// Free space of 8 x 8 m with a wall through it that has a gap about the middle.
struct GapInWall {
  double yaw = 0;  ///< leads through the gap
  double thickness = 0.2;
  double resolution = 0.05;
  double width = 0.9;
  Pose2 map_from_image;

  /// The centre of a pixel.
  Pose2 middle() const {
    return map_from_image * Pose2{{4 + resolution / 2, 4 - resolution / 2}, yaw};
  }

  OccupancyMap draw() const {
    OccupancyGrid grid;
    const int size = static_cast<int>(std::lround(8 / resolution));
    grid.geometry = {size, size, resolution, map_from_image};
    const Pose2 door_from_map = inverse(middle());
    for (std::size_t i = 0; i < grid.geometry.pixelCount(); ++i) {
      const Point2 p = door_from_map * grid.geometry.center(grid.geometry.pixel(i));
      const bool wall = std::abs(p.x()) <= thickness / 2 && std::abs(p.y()) >= width / 2;
      grid.values.push_back(wall ? 100 : 0);
    }
    return OccupancyMap(grid);
  }
};

/// Asks 12 times from about the gap and expects it within these bounds.
void expectFound(const GapInWall& wall, double place_px, double yaw_deg, double width_px) {
  const OccupancyMap map = wall.draw();
  std::mt19937 random(1);
  for (int i = 0; i < 12; ++i) {
    NarrowPlaceQuery query;
    query.near_map = wall.middle().position + randomPoint(random, 0.6);
    query.yaw = wall.yaw + wall.map_from_image.yaw + randomPoint(random, 0.6).x();
    const auto place = findNarrowPlace(map, query);
    ASSERT_TRUE(place);
    const double off = (place->pose_map.position - wall.middle().position).norm();
    EXPECT_LE(off / wall.resolution, place_px);
    EXPECT_LE(angleBetween(place->pose_map.yaw, wall.middle().yaw) * 180 / M_PI, yaw_deg);
    EXPECT_LE(std::abs(place->width - wall.width) / wall.resolution, width_px);
    EXPECT_NEAR(place->distance, (place->pose_map.position - query.near_map).norm(), 1e-12);
  }
}

TEST(NarrowPlace, LiesExactlyInAGapOfAStraightWall) {
  for (const double resolution : {0.05, 0.025, 0.1}) {
    for (const int wall_px : {1, 3, 5}) {
      for (const int quarters : {0, 1, 2, 3}) {
        SCOPED_TRACE(testing::Message() << resolution << " m, " << wall_px << " px, " << quarters);
        GapInWall wall;
        wall.resolution = resolution;
        wall.thickness = resolution * (wall_px - 0.5);
        wall.yaw = quarters * M_PI / 2;
        wall.width = resolution * (resolution < 0.04 ? 35 : resolution < 0.06 ? 17 : 9);
        expectFound(wall, 0.5 + 1e-6, 1e-6, 1e-6);
      }
    }
  }
}

TEST(NarrowPlace, LiesInAGapOfAWallInAnyDirection) {
  for (const double resolution : {0.05, 0.025}) {
    for (const double thickness : {0.08, 0.2, 0.45}) {
      for (int deg = 0; deg < 180; deg += 15) {
        SCOPED_TRACE(testing::Message() << resolution << " m, " << thickness << ", " << deg);
        GapInWall wall;
        wall.resolution = resolution;
        wall.thickness = thickness;
        wall.yaw = deg * M_PI / 180;
        expectFound(wall, 0.75, 6, 1.25);
      }
    }
  }
}

TEST(NarrowPlace, TurnsWithTheMap) {
  GapInWall upright;
  upright.yaw = 0.5;
  GapInWall turned = upright;
  turned.map_from_image = {{-20, 35}, 2.1};
  NarrowPlaceQuery query;
  query.near_map = upright.middle().position + Point2(0.3, 0.2);
  query.yaw = 0.3;
  const auto expected = findNarrowPlace(upright.draw(), query);
  query.near_map = turned.map_from_image * query.near_map;
  query.yaw = *query.yaw + turned.map_from_image.yaw;
  const auto found = findNarrowPlace(turned.draw(), query);
  ASSERT_TRUE(expected && found);
  const Pose2 pose = turned.map_from_image * expected->pose_map;
  EXPECT_LT((found->pose_map.position - pose.position).norm(), 1e-9);
  EXPECT_LT(angleBetween(found->pose_map.yaw, pose.yaw), 1e-9);
  EXPECT_NEAR(found->width, expected->width, 1e-9);
}

TEST(NarrowPlace, LeadsInTheDirectionAskedFor) {
  const GapInWall wall;
  const OccupancyMap map = wall.draw();
  NarrowPlaceQuery query;
  query.near_map = wall.middle().position;
  for (const double yaw : {0., 0.7, 3., -2.5}) {
    query.yaw = yaw;
    EXPECT_LT(angleBetween(findNarrowPlace(map, query)->pose_map.yaw, yaw), M_PI / 4);
  }
  query.yaw = 1;  // 57 degrees
  EXPECT_FALSE(findNarrowPlace(map, query));
  query.yaw.reset();
  EXPECT_TRUE(findNarrowPlace(map, query));
}

TEST(NarrowPlace, IsTheDoorBesideTheCorridorAndNotTheCorridor) {
  // at 0.1 m: a corridor of 1.5 m with a door of 0.8 m
  std::vector<std::string> rows(15, std::string(60, '.'));
  rows.insert(rows.begin(), "##########################........##########################");
  rows.insert(rows.begin(), 25, std::string(60, '.'));
  rows.push_back(std::string(60, '#'));
  const OccupancyMap map = test::asciiMap(rows, 0.1);
  NarrowPlaceQuery query;
  query.near_map = {3, 0.85};  // the middle of the corridor
  const auto any = findNarrowPlace(map, query);
  ASSERT_TRUE(any);
  EXPECT_LT((any->pose_map.position - Point2(3, 1.65)).norm(), 0.1);
  EXPECT_NEAR(any->width, 0.8, 1e-9);
  query.yaw = 0;  // along the corridor
  const auto along = findNarrowPlace(map, query);
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->width, 1.5, 1e-3);
  EXPECT_NEAR(along->pose_map.position.y(), 0.85, 0.01);
}

TEST(NarrowPlace, IsNotInACornerNorBetweenAWallAndAChairLeg) {
  std::vector<std::string> rows(60, "#" + std::string(59, '.'));
  rows.back() = std::string(60, '#');
  rows[50][8] = '#';  // 0.35 m from one wall, 0.45 m from the other
  const OccupancyMap map = test::asciiMap(rows, 0.05);
  NarrowPlaceQuery query;
  query.near_map = {0.3, 0.3};
  EXPECT_FALSE(findNarrowPlace(map, query));
  query.max_clutter_diagonal = 0;  // a pillar then
  EXPECT_TRUE(findNarrowPlace(map, query));
}

TEST(NarrowPlace, MayEndAtUnknownSpaceOrTheMapsBorder) {
  std::vector<std::string> rows(40, std::string(60, '.'));
  rows[20] = std::string(20, '?') + std::string(16, '.') + std::string(24, '#');
  NarrowPlaceQuery query;
  query.near_map = {1.3, 1.1};
  EXPECT_NEAR(findNarrowPlace(test::asciiMap(rows, 0.05), query)->width, 0.8, 1e-9);
  rows[20] = std::string(16, '.') + std::string(44, '#');
  query.near_map = {0.3, 1.1};
  EXPECT_NEAR(findNarrowPlace(test::asciiMap(rows, 0.05), query)->width, 0.8, 1e-9);
}

/// A map with random walls.
OccupancyMap randomMap(std::mt19937& random) {
  OccupancyGrid grid;
  const int size = 40 + static_cast<int>(random() % 20);
  grid.geometry = {size, size, 0.1, {}};
  grid.values.assign(grid.geometry.pixelCount(), 0);
  for (int i = 0; i < 7; ++i) {
    const int x = static_cast<int>(random() % 50);
    const int y = static_cast<int>(random() % 50);
    const int right = x + 1 + static_cast<int>(random() % (i % 2 ? 25 : 3));
    const int top = y + 1 + static_cast<int>(random() % (i % 2 ? 3 : 25));
    for (int v = y; v < std::min(top, size); ++v) {
      for (int u = x; u < std::min(right, size); ++u)
        grid.values[grid.geometry.index({u, v})] = 100;
    }
  }
  return OccupancyMap(grid);
}

/// What is between two walls, by trying every pair of wall pixels.
struct Pair {
  Point2 middle;
  double width = 0;
  double cost = 0;
};

std::vector<Pair> allPairs(const cv::Mat1b& free_space, const NarrowPlaceQuery& query) {
  constexpr double kResolution = 0.1;
  std::vector<Point2> walls;
  for (int y = -1; y <= free_space.rows; ++y) {
    for (int x = -1; x <= free_space.cols; ++x) {
      const bool in_map = x >= 0 && y >= 0 && x < free_space.cols && y < free_space.rows;
      if (!in_map || free_space(y, x) == 0) walls.emplace_back(x + 0.5, y + 0.5);
    }
  }
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = i + 1; j < walls.size(); ++j) {
      const Point2 way = walls[j] - walls[i];
      const Point2 middle = (walls[i] + walls[j]) / 2;
      const double width = (way.norm() - way.norm() / way.cwiseAbs().maxCoeff()) * kResolution;
      const double distance = (middle * kResolution - query.near_map).norm();
      if (width < 0.3 - 1e-9 || width > query.max_width + 1e-9 || distance > query.reach) continue;
      const double across = std::atan2(way.y(), way.x());
      if (query.yaw && std::abs(std::sin(across - *query.yaw)) < std::sqrt(0.5) - 1e-9) continue;
      const bool clear = std::none_of(walls.begin(), walls.end(), [&](const Point2& w) {
        return (w - middle).squaredNorm() < way.squaredNorm() / 4 - 1e-6;
      });
      if (clear) pairs.push_back({middle * kResolution, width, costOfPlace(width, distance)});
    }
  }
  return pairs;
}

TEST(NarrowPlace, IsTheCheapestPairOfWallsThatNothingIsBetween) {
  std::mt19937 random(3);
  int found = 0;
  int none = 0;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    const OccupancyMap map = randomMap(random);
    NarrowPlaceQuery query;
    query.near_map = Point2(2, 2) + randomPoint(random, 1.9);
    query.max_width = 1.5;
    query.reach = 0.8;
    query.max_clutter_diagonal = 0;
    if (trial % 3 > 0) query.yaw = randomPoint(random, M_PI).x();
    AreaParams cleaning;
    cleaning.max_clutter_diagonal = 0;
    const auto pairs = allPairs(cleanFreeSpace(map, cleaning), query);
    const auto place = findNarrowPlace(map, query);
    ASSERT_EQ(place.has_value(), !pairs.empty());
    ++(place ? found : none);
    if (!place) continue;
    const auto cheaper = [](const Pair& a, const Pair& b) { return a.cost < b.cost; };
    const double least = std::min_element(pairs.begin(), pairs.end(), cheaper)->cost;
    EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(),
                            [&](const Pair& pair) {
                              return pair.cost <= least + 1e-9 &&
                                     std::abs(pair.width - place->width) <= 0.25 &&
                                     (pair.middle - place->pose_map.position).norm() <= 0.5;
                            }))
        << place->pose_map.position.transpose() << ", " << place->width;
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(none, 10);
}

TEST(NarrowPlace, CanBeShut) {
  for (int deg = 0; deg < 180; deg += 7) {
    GapInWall wall;
    wall.yaw = deg * M_PI / 180;
    const OccupancyMap map = wall.draw();
    NarrowPlaceQuery query;
    query.near_map = wall.middle().position + Point2(0.2, 0.1);
    const auto place = findNarrowPlace(map, query);
    ASSERT_TRUE(place);
    DoorTag door;
    door.pose_map = place->pose_map;
    door.width = place->width;
    const auto barrier = findBarrier(cleanFreeSpace(map, {}), map.geometry(), door);
    ASSERT_TRUE(barrier);
    EXPECT_NEAR(barrier->jambs_map.length(), place->width, 0.051) << deg;
  }
}

}  // namespace
}  // namespace agrid
