// SPDX-License-Identifier: BSD-3-Clause
#include "planning/area_routes.h"

#include <gtest/gtest.h>

#include "planning/plan_oracle.h"

namespace agrid {
namespace {

using test::Scene;

Door doorAt(std::uint32_t id, AreaId a, AreaId b, const Segment& jambs) {
  Door door;
  door.id = DoorId{id};
  door.name = "door " + std::to_string(id);
  door.areas = {a, b};
  door.jambs_map = jambs;
  return door;
}

/// Two rooms, A and B, with a wide and a narrow door between them; a cupboard in the middle splits
/// A for a large robot.
Scene twoDoors() {
  Scene scene = test::sceneOf({"#################",  //
                               "#.......#.......#",  //
                               "#...............#",  //
                               "#.......#.......#",  //
                               "#.......#.......#",  //
                               "#.####..#.......#",  //
                               "#.####..#.......#",  //
                               "#...............#",  //
                               "#...............#",  //
                               "#...............#",  //
                               "#.......#.......#",  //
                               "#################"});
  scene.areas.assign(12, " AAAAAAAABBBBBBB ");
  scene.areas.front() = scene.areas.back() = std::string(17, ' ');
  const AreaId a{1};
  const AreaId b{2};
  scene.doors = {doorAt(1, a, b, {{8.5, 9}, {8.5, 10}}), doorAt(2, a, b, {{8.5, 2}, {8.5, 5}})};
  return scene;
}

PlannerParams radius(double r) {
  PlannerParams params;
  params.robot_radius = r;
  return params;
}

RouteList routesIn(const Scene& scene, double r, const PlanRequest& request, std::size_t count) {
  return Planner(test::mapOf(scene), radius(r)).routes(request, count);
}

TEST(AreaRoutes, DifferInTheirDoorsShortestFirst) {
  const Scene scene = twoDoors();
  const RouteList list = routesIn(scene, 0, test::requestFrom(scene.at(6, 8), scene.at(12, 8)), 5);
  ASSERT_EQ(list.status, PlanStatus::kSuccess);
  ASSERT_EQ(list.routes.size(), 2U);
  EXPECT_EQ(list.routes[0].doors, std::vector<std::size_t>{0});
  EXPECT_EQ(list.routes[1].doors, std::vector<std::size_t>{1});
  EXPECT_LT(list.routes[0].length, list.routes[1].length);
  for (const Route& route : list.routes) {
    EXPECT_EQ(route.areas, (std::vector<std::size_t>{0, 1}));
  }
}

TEST(AreaRoutes, UseNoDoorThatIsTooNarrowOrClosed) {
  Scene scene = twoDoors();
  const PlanRequest request = test::requestFrom(scene.at(3, 8), scene.at(12, 3));
  const RouteList wide = routesIn(scene, 1, request, 5);
  ASSERT_EQ(wide.status, PlanStatus::kNoRoute) << "the cupboard leaves no way south";
  const PlanRequest south = test::requestFrom(scene.at(3, 3), scene.at(12, 8));
  const RouteList one = routesIn(scene, 1, south, 5);
  ASSERT_EQ(one.status, PlanStatus::kSuccess) << one.message;
  ASSERT_EQ(one.routes.size(), 1U);
  EXPECT_EQ(one.routes[0].doors, std::vector<std::size_t>{1});
  scene.doors[1].state = DoorState::kClosed;
  const RouteList round = routesIn(scene, 0, south, 5);
  ASSERT_EQ(round.routes.size(), 1U);
  EXPECT_EQ(round.routes[0].doors, std::vector<std::size_t>{0});
}

TEST(AreaRoutes, LeadToAnArea) {
  const Scene scene = twoDoors();
  PlanRequest request = test::requestFrom(scene.at(6, 8), Point2::Zero());
  request.goal = AreaGoal{AreaId{2}, false};
  const RouteList list = routesIn(scene, 0, request, 1);
  ASSERT_EQ(list.routes.size(), 1U);
  EXPECT_EQ(list.routes[0].areas, (std::vector<std::size_t>{0, 1}));
  request.goal = AreaGoal{AreaId{1}, false};
  const RouteList here = routesIn(scene, 0, request, 3);
  ASSERT_EQ(here.routes.size(), 1U);
  EXPECT_TRUE(here.routes[0].doors.empty());
}

TEST(AreaRoutes, SayWhereAreasMeetWithoutADoor) {
  Scene scene = twoDoors();
  scene.doors.clear();
  const RouteList list = routesIn(scene, 0, test::requestFrom(scene.at(6, 8), scene.at(12, 8)), 1);
  ASSERT_EQ(list.routes.size(), 1U);
  EXPECT_EQ(list.routes[0].doors, std::vector<std::size_t>{kNoDoor});
}

}  // namespace
}  // namespace agrid
