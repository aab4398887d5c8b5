// SPDX-License-Identifier: BSD-3-Clause
// Areas that change under regions that stay, while doors are opened and closed.
#include "planning/region_labels.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "planning/switching.h"

namespace agrid::planning {
namespace {

using test::Switching;

/// What there is to know of a region, pixel by pixel.
struct SlowParts {
  std::map<std::uint16_t, PixelBox> boxes;
  std::vector<PixelBox> pairs;  ///< of pixels of several labels
};

std::map<std::uint32_t, SlowParts> slowParts(const MapGeometry& g, const RadiusLevel& level) {
  std::map<std::uint32_t, SlowParts> parts;
  const PortalGraph& regions = level.roadmap.regions();
  for (std::size_t i = 0; i < g.pixelCount(); ++i) {
    const std::uint32_t region = regions.nodeAt(i);
    if (region == kNoNode) continue;
    const Pixel p = g.pixel(i);
    parts[region].boxes[level.labels()[i]].add(p);
    for (const Pixel q : {Pixel{p.x + 1, p.y}, Pixel{p.x, p.y + 1}}) {
      const std::size_t k = g.index(q);
      if (regions.nodeAt(k) != region || level.labels()[k] == level.labels()[i]) continue;
      PixelBox pair;
      pair.add(p);
      pair.add(q);
      parts[region].pairs.push_back(pair);
    }
  }
  return parts;
}

bool isWithin(const PixelBox& a, const PixelBox& b) {
  const PixelBox both = common(a, b);
  return both.low == a.low && both.high == a.high;
}

/// @return how many regions hold pixels of several areas
int expectLabels(const MapGeometry& g, const RadiusLevel& level) {
  const RegionLabels& labels = level.regionLabels();
  int shared = 0;
  for (const auto& [region, slow] : slowParts(g, level)) {
    const auto parts = labels.partsOf(region);
    EXPECT_EQ(parts != nullptr, slow.boxes.size() > 1);
    if (!parts) {
      EXPECT_EQ(labels.labelOf(region), slow.boxes.begin()->first);
      continue;
    }
    ++shared;
    EXPECT_EQ(parts->boxes.size(), slow.boxes.size());
    for (const auto& [label, box] : slow.boxes) {
      EXPECT_EQ(parts->boxes.at(label).low, box.low);
      EXPECT_EQ(parts->boxes.at(label).high, box.high);
    }
    for (const PixelBox& pair : slow.pairs) {
      EXPECT_TRUE(std::any_of(parts->borders.begin(), parts->borders.end(),
                              [&](const Portal& border) { return isWithin(pair, border.box); }));
    }
    for (const Portal& border : parts->borders) {
      EXPECT_EQ(border.nodes[0], level.labels()[g.index(border.middle)]);
      EXPECT_EQ(border.nodes[1], level.labels()[g.index(border.beyond)]);
    }
  }
  for (const auto& [region, parts] : labels.parts()) {
    EXPECT_GE(level.roadmap.regions().boxOf(region).high.x, 0);
  }
  return shared;
}

/// Some pixels go to another area, or all of an area do.
void changeAreas(std::mt19937& random, Switching& s) {
  const MapGeometry& g = s.trial.scene.grid.geometry;
  auto changed = std::make_shared<SemanticMap>(*s.map);
  AreaMap& areas = changed->area_map;
  std::vector<std::uint16_t> labels = areas.pixel_labels.vector();
  const auto count = areas.areas.size();
  const auto from = static_cast<std::uint16_t>(1 + random() % count);
  const auto to = static_cast<std::uint16_t>(1 + random() % count);
  const int end = static_cast<int>(random() % static_cast<unsigned>(2 * g.width));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == from && g.pixel(i).x < end) labels[i] = to;
  }
  areas.pixel_labels = std::move(labels);
  s.map = std::move(changed);
  s.planner = std::make_unique<Planner>(s.map, *s.planner);
}

TEST(RegionLabels, AreThoseOfThePixels) {
  std::mt19937 random(62);
  int shared = 0;
  for (int i = 0; i < 300; ++i) {
    Switching s = test::randomSwitching(random);
    for (int k = 0; k < 8; ++k) {
      SCOPED_TRACE("trial " + std::to_string(i) + ", step " + std::to_string(k));
      const MapGeometry& g = s.trial.scene.grid.geometry;
      for (const double radius : {s.trial.params.robot_radius, 1.2 * g.resolution}) {
        if (k % 3 == 2 && radius != s.trial.params.robot_radius) continue;  // several steps at once
        shared += expectLabels(g, *test::levelOf(*s.planner, radius));
        if (HasFailure()) return;
      }
      random() % 2 == 0 ? changeAreas(random, s) : s.switchSome(random);
    }
  }
  EXPECT_GT(shared, 250);
}

TEST(RegionLabels, AreasThatShareRegionsAreReachedWhereAPlannerFromScratchReachesThem) {
  std::mt19937 random(63);
  int found = 0;
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    Switching s = test::randomSwitching(random);
    for (int k = 0; k < 6; ++k) {
      SCOPED_TRACE("trial " + std::to_string(i) + ", step " + std::to_string(k));
      random() % 2 == 0 ? changeAreas(random, s) : s.switchSome(random);
      const auto& areas = s.map->area_map.areas;
      PlanRequest request =
          test::requestFrom(s.trial.scene.at(s.trial.start), s.trial.scene.at(s.trial.goal));
      request.goal = AreaGoal{areas[random() % areas.size()].id};
      const Planner fresh(s.map, s.trial.params);
      const Plan plan = s.planner->plan(request);
      const Plan other = fresh.plan(request);
      ASSERT_EQ(plan.status, other.status) << plan.message << " / " << other.message;
      EXPECT_EQ(plan.message, other.message);
      apart += plan.status == PlanStatus::kNoRoute ? 1 : 0;
      if (plan.status != PlanStatus::kSuccess) continue;
      ++found;
      EXPECT_LE(plan.length_bound, other.length + 1e-6);
      EXPECT_LE(other.length_bound, plan.length + 1e-6);
      const auto end = s.map->map().geometry().pixelAt(plan.path_map.back().position);
      const std::size_t label = s.map->area_map.pixel_labels[s.map->map().geometry().index(*end)];
      EXPECT_EQ(areas[label - 1].id, std::get<AreaGoal>(request.goal).area);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(apart, 30);
}

}  // namespace
}  // namespace agrid::planning
