// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/swept_robot.h"

#include <random>

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using planning::FreeSpace;
using planning::MotionPiece;
using planning::Obstacles;
using planning::SweptRobot;
using test::Scene;
using test::SlowFreeSpace;

class Swept {
 public:
  Swept(const Scene& scene, const PlannerParams& params)
      : map_(test::mapOf(scene)),
        obstacles_(*map_, false),
        slow_(scene, params, params.robot_radius) {
    const MapGeometry& g = scene.grid.geometry;
    const auto distances = std::make_shared<const planning::SquaredDistances>(
        planning::obstacleDistances(g, obstacles_, params.clearance));
    const FreeSpace free(g, distances, params.robot_radius);
    if (params.footprint.empty()) {
      robot = std::make_unique<const SweptRobot>(free);
    } else {
      robot = std::make_unique<const SweptRobot>(free, obstacles_, params.footprint);
    }
  }
  /// Whether a square of pixels around a point, `reach` of a pixel wide to each side, is free.
  bool isSquareFree(const Point2& p_map, double reach) const {
    const MapGeometry& g = map_->map().geometry();
    const Point2 p = planning::pixelCoordinates(g, p_map);
    for (int y = int(std::ceil(p.y() - reach - 0.5)); y <= int(std::floor(p.y() + reach + 0.5));
         ++y) {
      for (int x = int(std::ceil(p.x() - reach - 0.5)); x <= int(std::floor(p.x() + reach + 0.5));
           ++x) {
        if (!slow_.isFree({x, y})) return false;
      }
    }
    return true;
  }
  std::unique_ptr<const SweptRobot> robot;

 private:
  std::shared_ptr<const SemanticMap> map_;
  Obstacles obstacles_;
  SlowFreeSpace slow_;
};

MotionPiece randomPiece(std::mt19937& random, const Point2& from) {
  std::uniform_real_distribution<double> unit(-1, 1);
  MotionPiece piece;
  piece.from = {from, 3.1416 * unit(random)};
  piece.length = 8 * unit(random);
  piece.turn = (unit(random) > 0 ? 4 : 0) * unit(random);
  piece.is_arc = unit(random) > -0.5;
  piece.direction = 3.1416 * unit(random);
  if (!piece.is_arc) piece.length = std::abs(piece.length);
  return piece;
}

TEST(SweptRobot, CirclesMoveWhereEveryPixelTouchedIsFreeAndOnlyThere) {
  std::mt19937 random(3);
  int accepted = 0;
  int refused = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene;
    scene.grid = test::randomPlan(random, {30, 24, 0.5, {{-3, 2}, 0.4}});
    PlannerParams params;
    params.robot_radius = 0.3 * (round % 4);
    params.clearance = round % 2 == 0 ? Clearance::kCostmap : Clearance::kStrict;
    const Swept swept(scene, params);
    for (int i = 0; i < 60; ++i) {
      const Point2 from = scene.at(static_cast<double>(random() % 300) / 10,
                                   static_cast<double>(random() % 240) / 10);
      const MotionPiece piece = randomPiece(random, from);
      const bool free = swept.robot->isFree(piece);
      (free ? accepted : refused) += 1;
      bool touches = false;
      bool nearly_touches = false;
      for (int k = 0; k <= 4000; ++k) {
        const Point2 p = piece.at(k / 4000.0).position;
        touches |= !swept.isSquareFree(p, 0);
        nearly_touches |= !swept.isSquareFree(p, 3.5 / 64);
      }
      EXPECT_FALSE(free && touches);
      EXPECT_TRUE(free || nearly_touches);
    }
  }
  EXPECT_GT(accepted, 300);
  EXPECT_GT(refused, 300);
}

/// A rectangle against a square by their axes (the separating axis theorem).
bool meet(const Polygon& rectangle, const Point2& center, double half) {
  Polygon square;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) square.push_back(center + Point2(x, y));
  }
  const Point2 side = (rectangle[1] - rectangle[0]).normalized();
  for (const Point2& axis : {Point2(1, 0), Point2(0, 1), side, Point2(-side.y(), side.x())}) {
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
    for (const Point2& p : rectangle) {
      low[0] = std::min(low[0], axis.dot(p));
      high[0] = std::max(high[0], axis.dot(p));
    }
    for (const Point2& p : square) {
      low[1] = std::min(low[1], axis.dot(p));
      high[1] = std::max(high[1], axis.dot(p));
    }
    if (low[0] > high[1] || low[1] > high[0]) return false;
  }
  return true;
}

bool touchesObstacle(const Scene& scene, const Polygon& outline, const Pose2& pose, double half) {
  const MapGeometry& g = scene.grid.geometry;
  const Pose2 image_from_robot = inverse(g.map_from_image) * pose;
  Polygon turned;
  for (const Point2& p : outline) turned.push_back(image_from_robot * p / g.resolution);
  for (int y = -4; y < g.height + 4; ++y) {
    for (int x = -4; x < g.width + 4; ++x) {
      const bool obstacle = !g.contains({x, y}) || scene.grid.values[g.index({x, y})] != 0;
      if (obstacle && meet(turned, Point2(x + 0.5, y + 0.5), half)) return true;
    }
  }
  return false;
}

TEST(SweptRobot, OutlinesMoveWhereNoPixelTheyTouchIsAnObstacle) {
  std::mt19937 random(4);
  PlannerParams params;
  params.footprint = {{0.8, 0.3}, {-0.4, 0.3}, {-0.4, -0.3}, {0.8, -0.3}};
  params.robot_radius = 0;
  int accepted = 0;
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    Scene scene;
    scene.grid = test::randomPlan(random, {30, 24, 0.25, {{1, -2}, -0.3}});
    params.clearance = round % 2 == 0 ? Clearance::kCostmap : Clearance::kStrict;
    const Swept swept(scene, params);
    for (int i = 0; i < 40; ++i) {
      const Point2 from = scene.at(1.5 + static_cast<double>(random() % 270) / 10,
                                   1.5 + static_cast<double>(random() % 210) / 10);
      MotionPiece piece = randomPiece(random, from);
      piece.length /= 4;
      if (i % 5 == 0) piece.length = 0;
      const bool free = swept.robot->isFree(piece);
      (free ? accepted : refused) += 1;
      bool touches = false;
      bool nearly_touches = false;
      for (int k = 0; k <= 40; ++k) {
        touches |= touchesObstacle(scene, params.footprint, piece.at(k / 40.0), 0.5);
        nearly_touches |= touchesObstacle(scene, params.footprint, piece.at(k / 40.0), 0.6) ||
                          !swept.isSquareFree(piece.at(k / 40.0).position, 0.1);
      }
      const bool strict = params.clearance == Clearance::kStrict;
      EXPECT_FALSE(free && touches);
      EXPECT_TRUE(free || nearly_touches || strict);
    }
  }
  EXPECT_GT(accepted, 50);
  EXPECT_GT(refused, 50);
}

TEST(SweptRobot, NoWallIsTooThinForAMotion) {
  Scene scene = test::sceneOf(std::vector<std::string>(20, std::string(20, '.')), 0.1);
  for (int y = 0; y < 20; ++y) scene.grid.values[scene.grid.geometry.index({10, y})] = 100;
  PlannerParams params;
  params.robot_radius = 0;
  const Swept swept(scene, params);
  MotionPiece piece;
  piece.from = {scene.at(2, 10), 0};
  piece.is_arc = true;
  piece.length = 0.7;
  EXPECT_TRUE(swept.robot->isFree(piece));
  for (const double turn : {0.0, 0.3, -1.0}) {
    piece.turn = turn;
    piece.length = 1.5;
    EXPECT_FALSE(swept.robot->isFree(piece)) << turn;
  }
}

}  // namespace
}  // namespace agrid
