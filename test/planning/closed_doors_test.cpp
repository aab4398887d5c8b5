// SPDX-License-Identifier: BSD-3-Clause
// What closing a door changes, on random maps: nothing gets better, nothing goes through it, and
// the answer says why there is none.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/random_trial.h"

namespace agrid {
namespace {

using test::SlowFreeSpace;
using test::Trial;

/// A wall across the map with a gap, and the door in it.
struct DoorTrial {
  Trial trial;
  Segment gap_map;
};

DoorTrial randomDoor(std::mt19937& random) {
  DoorTrial result{test::randomTrial(random), {}};
  result.trial.params.robot_radius =
      0.8 * static_cast<double>(random() % 3) * result.trial.scene.grid.geometry.resolution;
  OccupancyGrid& grid = result.trial.scene.grid;
  const MapGeometry& g = grid.geometry;
  const bool upright = random() % 2 == 0;
  const int length = upright ? g.height : g.width;
  const int at = static_cast<int>(random() % static_cast<unsigned>(upright ? g.width : g.height));
  const int width = 1 + static_cast<int>(random() % 12);
  const int first = static_cast<int>(random() % static_cast<unsigned>(length));
  // half of the walls have a second gap, without a door
  const int other = static_cast<int>(random() % static_cast<unsigned>(2 * length));
  for (int i = 0; i < length; ++i) {
    if ((i >= first && i < first + width) || (i >= other && i < other + 9)) continue;
    grid.values[g.index(upright ? Pixel{at, i} : Pixel{i, at})] = 100;
  }
  const double last = std::min(first + width, length) - 0.5;
  const auto point = [&](double i) {
    return upright ? result.trial.scene.at(at, i) : result.trial.scene.at(i, at);
  };
  result.gap_map = {point(first - 0.5), point(last)};
  Door door;
  door.id = DoorId{1};
  door.name = "the door";
  door.jambs_map = result.gap_map;
  door.width = (last - first + 0.5) * g.resolution;
  result.trial.scene.doors = {door};
  return result;
}

double side(const Segment& line, const Point2& p) {
  const Point2 along = line.b - line.a;
  const Point2 to = p - line.a;
  return along.x() * to.y() - along.y() * to.x();
}

/// Whether two segments cross properly.
bool cross(const Segment& a, const Segment& b) {
  return side(a, b.a) * side(a, b.b) < 0 && side(b, a.a) * side(b, a.b) < 0;
}

TEST(ClosedDoors, P6_NothingGoesThroughAndTheDoorIsNamed) {
  std::mt19937 random(81);
  int shut = 0;
  int around = 0;
  int named = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    DoorTrial door = randomDoor(random);
    Trial& trial = door.trial;
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    preferFree(random, slow, trial);
    const PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    const Plan open = Planner(test::mapOf(trial.scene), trial.params).plan(request);
    trial.scene.doors[0].state = DoorState::kClosed;
    const Planner planner(test::mapOf(trial.scene), trial.params);
    const Plan closed = planner.plan(request);
    EXPECT_EQ(planner.routes(request, 1).status, closed.status);
    if (closed.status == PlanStatus::kSuccess) {
      ASSERT_EQ(open.status, PlanStatus::kSuccess);
      checkPath(trial, slow, closed);
      EXPECT_GE(closed.length, open.length_bound - 1e-9);
      for (std::size_t k = 1; k < closed.path_map.size(); ++k) {
        EXPECT_FALSE(
            cross(door.gap_map, {closed.path_map[k - 1].position, closed.path_map[k].position}));
      }
      around += closed.length > open.length + 1e-6 ? 1 : 0;
    } else if (open.status == PlanStatus::kSuccess && closed.status == PlanStatus::kNoRoute) {
      ++shut;
      named += closed.message.find("closed door 'the door'") != std::string::npos ? 1 : 0;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(shut, 100);
  EXPECT_GT(around, 10);
  EXPECT_EQ(named, shut);  // one door is to blame for each of them
  RecordProperty("named", std::to_string(named) + " of " + std::to_string(shut));
}

/// Two rooms, a deep door of two pixels between them, and things right in front of it.
test::Scene deepDoor(DoorState state) {
  test::Scene scene = test::sceneOf(
      {
          "#################",  //
          "#......#########.",  //
          "#......#########.",  //
          "#..#...........#.",  //
          "#..#...........#.",  //
          "#......####....#.",  //
          "#......####....#.",  //
          "#......####......",  //
          "#################",
      },
      0.1);
  Door door;
  door.name = "deep";
  door.state = state;
  door.width = 0.2;
  door.jambs_map = {{0.85, 0.4}, {0.85, 0.6}};
  scene.doors = {door};
  return scene;
}

TEST(ClosedDoors, P6_ANoSaysWhetherADoorIsClosedOrTooNarrow) {
  const auto messageFor = [](DoorState state, double radius) {
    const test::Scene scene = deepDoor(state);
    PlannerParams params;
    params.robot_radius = radius;
    const Planner planner(test::mapOf(scene), params);
    const Plan plan = planner.plan(test::requestFrom({0.25, 0.25}, {1.35, 0.45}));
    return std::string(toString(plan.status)) + " " + plan.message;
  };
  EXPECT_EQ(messageFor(DoorState::kOpen, 0), "SUCCESS ");
  EXPECT_NE(messageFor(DoorState::kClosed, 0).find("in the way: closed door 'deep'"),
            std::string::npos);
  EXPECT_NE(messageFor(DoorState::kOpen, 0.1).find("in the way: too narrow door 'deep' (0.2 m)"),
            std::string::npos);
  EXPECT_NE(messageFor(DoorState::kClosed, 0.1).find("closed and too narrow door 'deep' (0.2 m)"),
            std::string::npos);
}

}  // namespace
}  // namespace agrid
