// SPDX-License-Identifier: BSD-3-Clause
// Planners made from former ones answer like planners made from scratch.
#include <random>

#include <gtest/gtest.h>

#include "planning/planner_access.h"
#include "planning/sample_roads.h"
#include "planning/three_rooms.h"

namespace agrid {
namespace {

using test::SlowFreeSpace;
using test::Trial;

/// The area of each pixel of a path, and how often it changes, must be those of the map.
void expectAreasOf(const SemanticMap& map, const Plan& plan) {
  ASSERT_EQ(plan.route.doors.size() + 1, std::max<std::size_t>(plan.route.areas.size(), 1));
  for (std::size_t i = 0; i < plan.route.areas.size(); ++i) {
    ASSERT_LT(plan.route.areas[i], map.area_map.areas.size());
  }
  for (const Pose2& pose : plan.path_map) {
    const auto pixel = map.map().geometry().pixelAt(pose.position);
    ASSERT_TRUE(pixel);
    const std::uint16_t label = map.area_map.pixel_labels[map.map().geometry().index(*pixel)];
    if (label == 0) continue;
    EXPECT_TRUE(std::count(plan.route.areas.begin(), plan.route.areas.end(), label - 1U) > 0);
  }
}

void expectLike(const SemanticMap& map, const Plan& plan, const Plan& fresh, double tolerance) {
  ASSERT_EQ(plan.status, fresh.status) << plan.message << " / " << fresh.message;
  EXPECT_EQ(plan.message, fresh.message);
  if (plan.status != PlanStatus::kSuccess) return;
  EXPECT_NEAR(plan.length, fresh.length, tolerance * fresh.length);
  EXPECT_LE(plan.length_bound, fresh.length + 1e-9);
  expectAreasOf(map, plan);
}

/// Names, states that are not closed, areas joined, split and numbered anew.
SemanticMap editedMap(std::mt19937& random, const SemanticMap& map) {
  SemanticMap edited = map;
  AreaMap& areas = edited.area_map;
  const MapGeometry& geometry = map.map().geometry();
  std::vector<std::uint16_t> labels = areas.pixel_labels.vector();
  const auto any = static_cast<std::uint16_t>(1 + random() % areas.areas.size());
  const auto other = static_cast<std::uint16_t>(1 + random() % areas.areas.size());
  const int split_x = static_cast<int>(random() % static_cast<unsigned>(geometry.width));
  const auto kind = random() % 5;
  if (kind == 0) areas.areas[any - 1U].name += "'";
  if (kind == 1 && !areas.doors.empty()) areas.doors.front().name += "'";
  if (kind == 2) areas.areas.push_back(areas.areas[any - 1U]);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (kind == 2 && labels[i] == any && geometry.pixel(i).x < split_x) {
      labels[i] = static_cast<std::uint16_t>(areas.areas.size());
    }
    if (kind == 3 && labels[i] == any) labels[i] = other;
    if (kind == 4 && (labels[i] == any || labels[i] == other)) {
      labels[i] = static_cast<std::uint16_t>(any + other - labels[i]);
    }
  }
  for (std::size_t k = 0; k < areas.areas.size(); ++k) {
    areas.areas[k].id = AreaId{static_cast<std::uint32_t>(k + 1)};
  }
  if (kind >= 2) areas.pixel_labels = std::move(labels);
  return edited;
}

TEST(Planner, AnEditedMapIsAnsweredLikeByAPlannerFromScratch) {
  std::mt19937 random(77);
  int found = 0;
  for (int i = 0; i < 250; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    Trial trial = test::randomTrial(random);
    test::addAreasOfAnyShape(random, trial.scene);
    const SlowFreeSpace slow(trial.scene, trial.params, trial.params.robot_radius);
    auto map = test::mapOf(trial.scene);
    auto planner = std::make_unique<Planner>(map, trial.params);
    for (int edit = 0; edit < 4; ++edit) {
      map = std::make_shared<const SemanticMap>(editedMap(random, *map));
      planner = std::make_unique<Planner>(map, *planner);
      const Planner fresh(map, trial.params);
      test::preferFree(random, slow, trial);
      PlanRequest request =
          test::requestFrom(trial.scene.at(trial.start), trial.scene.at(trial.goal));
      const Plan plan = planner->plan(request);
      // Other regions, other middles of portals.
      expectLike(*map, plan, fresh.plan(request), 0.1);
      if (plan.status == PlanStatus::kSuccess) {
        test::checkPath(trial, slow, plan);
        ++found;
      }
      request.goal = AreaGoal{map->area_map.areas[random() % map->area_map.areas.size()].id};
      expectLike(*map, planner->plan(request), fresh.plan(request), 0.3);
      EXPECT_EQ(planner->routes(request, 3).routes.size(), fresh.routes(request, 3).routes.size());
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(found, 200);
}

TEST(Planner, WhatAnEditLeavesAloneIsShared) {
  const test::Scene scene = test::threeRooms();
  const auto map = test::mapOf(scene);
  const Planner planner(map, test::pointRobot());
  auto renamed = std::make_shared<SemanticMap>(*map);
  renamed->area_map.areas[0].name = "kitchen";
  renamed->area_map.doors[0].name = "kitchen door";
  const Planner after(renamed, planner);
  const auto roadmapOf = [](const Planner& p) {
    const PlanRequest request = test::requestFrom({2.5, 5.5}, {3.5, 5.5});
    const planning::Query query = planning::checkedQuery(request, p.params(), 1);
    return &planning::PlannerAccess::core(p).taskOf(request, query, {}).level->roadmap;
  };
  EXPECT_EQ(roadmapOf(after), roadmapOf(planner));
  EXPECT_EQ(after.plan(test::requestFrom({2.5, 5.5}, {2.5, 1.5})).message,
            planner.plan(test::requestFrom({2.5, 5.5}, {2.5, 1.5})).message);
}

TEST(Planner, AFormerPlannerMayEndBeforeItsHeir) {
  const test::Scene scene = test::threeRooms();
  auto map = test::mapOf(scene);
  auto planner = std::make_unique<const Planner>(map, test::pointRobot());
  for (int i = 0; i < 3; ++i) {
    auto renamed = std::make_shared<SemanticMap>(*map);
    renamed->area_map.areas[0].name += "!";
    map = std::move(renamed);
    planner = std::make_unique<const Planner>(map, *planner);
  }
  PlanRequest request = test::requestFrom({2.5, 5.5}, {14.5, 5.5});
  EXPECT_EQ(planner->plan(request).status, PlanStatus::kSuccess);
  request.goal = AreaGoal{AreaId{3}};
  EXPECT_EQ(planner->plan(request).status, PlanStatus::kNoRoute);
  EXPECT_EQ(planner->routes(request, 2).status, PlanStatus::kNoRoute);
}

}  // namespace
}  // namespace agrid
