// SPDX-License-Identifier: BSD-3-Clause
// No robot's centre enters an area with the property cost=forbidden, and nothing else is forbidden.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "planning/sample_roads.h"
#include "planning/switching.h"
#include "planning/three_rooms.h"
#include "support/retagged_map.h"

namespace agrid {
namespace {

using test::SlowFreeSpace;
using test::Trial;

std::shared_ptr<const SemanticMap> withForbidden(const SemanticMap& map,
                                                 const std::vector<std::size_t>& areas) {
  auto changed = std::make_shared<SemanticMap>(map);
  for (Area& area : changed->area_map.areas) area.properties.erase("cost");
  for (const std::size_t i : areas) changed->area_map.areas[i].properties["cost"] = "forbidden";
  return changed;
}

std::vector<std::size_t> someAreas(std::mt19937& random, const SemanticMap& map) {
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < map.area_map.areas.size(); ++i) {
    if (random() % 3 == 0) some.push_back(i);
  }
  return some;
}

bool isForbidden(const SemanticMap& map, Pixel p) {
  const std::uint16_t label = map.area_map.pixel_labels[map.map().geometry().index(p)];
  return label != 0 && map.area_map.areas[label - 1U].properties.count("cost") != 0;
}

/// Free space without the forbidden areas but that of the start.
SlowFreeSpace allowed(const SemanticMap& map, const Trial& trial, SlowFreeSpace slow) {
  const MapGeometry& g = map.map().geometry();
  const auto& labels = map.area_map.pixel_labels;
  for (std::size_t i = 0; i < g.pixelCount(); ++i) {
    if (isForbidden(map, g.pixel(i)) && labels[i] != labels[g.index(trial.start)]) slow.block(i);
  }
  return slow;
}

PlanStatus expected(const SemanticMap& map, const Trial& trial, const SlowFreeSpace& slow) {
  if (!slow.isFree(trial.start)) return PlanStatus::kStartInvalid;
  if (!slow.isFree(trial.goal) || isForbidden(map, trial.goal)) return PlanStatus::kGoalInvalid;
  return slow.connects(trial.start, trial.goal) ? PlanStatus::kSuccess : PlanStatus::kNoRoute;
}

TEST(ForbiddenAreas, AreNeverEnteredAndNeverCauseAFalseNo) {
  std::mt19937 random(91);
  int found = 0;
  int shut = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = test::randomTrial(random);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    test::preferFree(random, slow, trial);
    test::addAreasOfAnyShape(random, trial.scene);
    const auto plain = test::mapOf(trial.scene);
    const auto map = withForbidden(*plain, someAreas(random, *plain));
    const SlowFreeSpace open = allowed(*map, trial, slow);
    const Planner planner(map, trial.params);
    const PlanRequest request =
        test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
    const Plan plan = planner.plan(request);
    ASSERT_EQ(plan.status, expected(*map, trial, open)) << plan.message;
    EXPECT_EQ(planner.routes(request, 1).status, plan.status);
    if (plan.status == PlanStatus::kSuccess) {
      test::checkPath(trial, open, plan);
      ++found;
    } else if (plan.status == PlanStatus::kNoRoute && slow.connects(trial.start, trial.goal)) {
      EXPECT_NE(plan.message.find("forbidden area '"), std::string::npos) << plan.message;
      ++shut;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(shut, 30);
}

TEST(ForbiddenAreas, AreObeyedAtOnceWhenTheyChangeUnderAPlannerWithDoors) {
  std::mt19937 random(92);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    test::Switching s = test::randomSwitching(random);
    for (int edit = 0; edit < 5; ++edit) {
      s.map = withForbidden(*s.map, someAreas(random, *s.map));
      s.switchSome(random);
      const planning::Obstacles obstacles(*s.map, s.trial.params.allow_unknown,
                                          s.trial.params.clearance);
      test::Scene with_doors = s.trial.scene;
      for (std::size_t k = 0; k < with_doors.grid.values.size(); ++k) {
        if (obstacles.at(k)) with_doors.grid.values[k] = 100;
      }
      const SlowFreeSpace slow(with_doors, s.trial.params, s.trial.params.robot_radius);
      test::preferFree(random, slow, s.trial);
      const SlowFreeSpace open = allowed(*s.map, s.trial, slow);
      const PlanRequest request =
          test::requestFrom(s.trial.scene.at(s.trial.start), s.trial.scene.at(s.trial.goal));
      const Plan plan = s.planner->plan(request);
      ASSERT_EQ(plan.status, expected(*s.map, s.trial, open)) << plan.message;
      const Plan fresh = Planner(s.map, s.trial.params).plan(request);
      ASSERT_EQ(plan.message, fresh.message);
      if (plan.status != PlanStatus::kSuccess) continue;
      test::checkPath(s.trial, open, plan);
      EXPECT_LE(plan.length_bound, fresh.length + 1e-9);
      EXPECT_NEAR(plan.length, fresh.length, 0.3 * fresh.length);
      ++found;
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(found, 200);
}

/// A corridor A around a room B, through which the way is shorter.
struct Detour {
  test::Scene scene = test::sceneOf({"###########",  //
                                     "#.........#",  //
                                     "#.###.###.#",  //
                                     "#.#.....#.#",  //
                                     "#.........#",  //
                                     "#.#.....#.#",  //
                                     "###########"});
  PlannerParams params;
  Detour() {
    params.robot_radius = 0;
    scene.areas = {"           ",  //
                   " AAAAAAAAA ",  //
                   " A   B   A ",  //
                   " A BBBBB A ",  //
                   " ABBBBBBBA ",  //
                   " A BBBBB A ",  //
                   "           "};
  }
  Plan plan(const std::vector<std::size_t>& forbidden, Pixel from, Pixel to) const {
    return Planner(withForbidden(*test::mapOf(scene), forbidden), params)
        .plan(test::requestFrom(scene.at(from), scene.at(to)));
  }
};

TEST(ForbiddenAreas, AreGoneAroundAlthoughTheWayThroughThemIsShorter) {
  const Detour drawn;
  EXPECT_NEAR(drawn.plan({}, {1, 2}, {9, 2}).length, 8, 1e-9);
  const Plan around = drawn.plan({1}, {1, 2}, {9, 2});
  EXPECT_EQ(around.route.areas, std::vector<std::size_t>{0});
  EXPECT_NEAR(around.length, 7 + 2 * std::hypot(0.5, 2.5), 1e-3);
  EXPECT_GE(around.length_bound, 8);
}

TEST(ForbiddenAreas, MayBeLeftButNotGoneTo) {
  const Detour drawn;
  const Plan out = drawn.plan({1}, {5, 1}, {1, 1});
  EXPECT_EQ(out.status, PlanStatus::kSuccess) << out.message;
  for (const Pixel start : {Pixel{1, 1}, Pixel{3, 1}}) {
    const Plan in = drawn.plan({1}, start, {5, 1});
    EXPECT_EQ(in.status, PlanStatus::kGoalInvalid);
    EXPECT_EQ(in.message, "the goal lies in the forbidden area 'B'");
  }
  PlanRequest request = test::requestFrom(drawn.scene.at(1, 1), drawn.scene.at(5, 1));
  const Planner planner(withForbidden(*test::mapOf(drawn.scene), {1}), drawn.params);
  for (const bool at_anchor : {false, true}) {
    request.goal = AreaGoal{AreaId{2}, at_anchor};
    EXPECT_EQ(planner.plan(request).status, PlanStatus::kGoalInvalid);
    EXPECT_EQ(planner.plan(request).message, "the area 'B' is forbidden");
  }
  // within the tolerance, the nearest place outside
  request = test::requestFrom(drawn.scene.at(1, 2), drawn.scene.at(2, 2));
  request.tolerance = 2;
  EXPECT_EQ(planner.plan(request).status, PlanStatus::kSuccess);
  EXPECT_TRUE(planner.plan(request).goal_moved);
}

TEST(ForbiddenAreas, AreNamedWhereTheyAreInTheWayAndDoorsWhereTheyAre) {
  test::Scene scene = test::threeRooms();
  for (std::string& row : scene.areas) {
    std::replace(row.begin() + 12, row.end(), 'B', 'D');
    std::replace(row.begin() + 5, row.begin() + 8, 'A', 'E');
  }
  const PlannerParams params = test::pointRobot();
  const PlanRequest request = test::requestFrom(scene.at(2, 5), scene.at(14, 5));
  const auto why = [&] {
    return Planner(withForbidden(*test::mapOf(scene), {1, 4}), params).plan(request).message;
  };
  EXPECT_EQ(why(),
            "free space does not connect start and goal for a radius of 0 m; in the way: forbidden "
            "area 'E', forbidden area 'B'");
  scene.doors.front().state = DoorState::kClosed;
  EXPECT_EQ(why(),
            "free space does not connect start and goal for a radius of 0 m; in the way: closed "
            "door 'the door'");
}

TEST(ForbiddenAreas, AreKeptOutOfByCurvesAndByPlannersOfOmpl) {
  const Detour drawn;
  PlanRequest request = test::requestFrom(drawn.scene.at(1, 2), drawn.scene.at(9, 2));
  const Planner planner(withForbidden(*test::mapOf(drawn.scene), {1}), drawn.params);
  request.planner = "RRTConnect";
  EXPECT_EQ(planner.plan(request).route.areas, std::vector<std::size_t>{0});
  request.planner.reset();
  request.turning_radius = 0.3;
  const Plan curve = planner.plan(request);
  EXPECT_EQ(curve.status, PlanStatus::kSuccess) << curve.message;
  EXPECT_EQ(curve.route.areas, std::vector<std::size_t>{0});
}

/// The request's answer after an area was tagged with a cost, by a planner made from a former one.
struct Tagged {
  std::shared_ptr<const SemanticMap> map;
  std::unique_ptr<Planner> planner;

  void tag(const Area& area, const std::string& cost) {
    AreaTag tag = test::areaAtSeed(static_cast<std::uint32_t>(area.id), area.name, area.anchor_map);
    tag.properties["cost"] = cost;
    map = std::make_shared<const SemanticMap>(test::after(*map, {PutTag{tag}}));
    planner = std::make_unique<Planner>(map, *planner);
  }
};

TEST(ForbiddenAreas, ATagOnALiveMapIsObeyedByTheNextRequest) {
  OfficeParams office;
  office.size = 300;
  office.seed = 3;
  Tagged live;
  live.map = std::make_shared<const SemanticMap>(
      annotate(test::structureOf(OccupancyMap(generateOffice(office).grid)), {}, {}));
  live.planner = std::make_unique<Planner>(live.map, PlannerParams{});
  const std::vector<Area> areas = live.map->area_map.areas;
  int tried = 0;
  for (std::size_t to = 1; to < areas.size(); ++to) {
    const PlanRequest request = test::requestFrom(areas[0].anchor_map, areas[to].anchor_map);
    const Plan before = live.planner->plan(request);
    if (before.status != PlanStatus::kSuccess || before.route.areas.size() < 3) continue;
    const std::size_t between = before.route.areas[1];
    live.tag(areas[between], "forbidden");
    const Plan without = live.planner->plan(request);
    if (without.status == PlanStatus::kSuccess) {
      const std::vector<std::size_t>& crossed = without.route.areas;
      EXPECT_EQ(std::count(crossed.begin(), crossed.end(), between), 0);
      EXPECT_GE(without.length, before.length_bound);
    } else {
      EXPECT_EQ(without.status, PlanStatus::kNoRoute);
      EXPECT_NE(without.message.find("forbidden area '" + areas[between].name), std::string::npos);
    }
    live.tag(areas[between], "1");
    EXPECT_NEAR(live.planner->plan(request).length, before.length, 1e-9);
    ++tried;
  }
  EXPECT_GT(tried, 2);
}

}  // namespace
}  // namespace agrid
