// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "planning/planner_access.h"
#include "planning/sample_roads.h"

namespace agrid::test {

/// Doors anywhere, in any direction; most of them in gaps of walls.
inline std::vector<Door> randomDoors(std::mt19937& random, const Trial& trial) {
  const MapGeometry& g = trial.scene.grid.geometry;
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  std::vector<Door> doors;
  const int count = 1 + below(5);
  while (static_cast<int>(doors.size()) < count) {
    const Pixel a{below(g.width), below(g.height)};
    const bool upright = below(2) == 0;
    const Pixel b = below(4) == 0 ? Pixel{below(g.width), below(g.height)}
                    : upright     ? Pixel{a.x, std::min(a.y + below(8), g.height - 1)}
                                  : Pixel{std::min(a.x + below(8), g.width - 1), a.y};
    Door door;
    door.id = DoorId{static_cast<std::uint32_t>(doors.size() + 1)};
    door.name = "door " + std::to_string(doors.size() + 1);
    door.state = below(2) == 0 ? DoorState::kClosed : DoorState::kOpen;
    door.jambs_map = {trial.scene.at(a), trial.scene.at(b)};
    doors.push_back(door);
  }
  return doors;
}

inline std::shared_ptr<const planning::RadiusLevel> levelOf(const Planner& planner, double radius) {
  PlanRequest request;
  request.goal = PlanPoint{};
  planning::Query query = planning::checkedQuery(request, planner.params(), 1);
  query.robot_radius = radius;
  return planning::PlannerAccess::core(planner).level(query, {});
}

/// A map of which doors are opened and closed, and a planner that is made from the one before.
struct Switching {
  Trial trial;
  std::shared_ptr<const SemanticMap> map;
  std::unique_ptr<Planner> planner;

  void switchSome(std::mt19937& random) {
    auto changed = std::make_shared<SemanticMap>(*map);
    for (Door& door : changed->area_map.doors) {
      if (random() % 3 != 0) continue;
      door.state = door.state == DoorState::kClosed ? DoorState::kOpen : DoorState::kClosed;
    }
    map = std::move(changed);
    planner = std::make_unique<Planner>(map, *planner);
  }
};

inline Switching randomSwitching(std::mt19937& random) {
  Switching result;
  result.trial = randomTrial(random);
  const double radii_px[] = {0, 0, 0.5, 1, 1.5, 2, 3};
  result.trial.params.robot_radius =
      radii_px[random() % 7] * result.trial.scene.grid.geometry.resolution;
  addAreasOfAnyShape(random, result.trial.scene);
  result.trial.scene.doors = randomDoors(random, result.trial);
  result.map = mapOf(result.trial.scene);
  result.planner = std::make_unique<Planner>(result.map, result.trial.params);
  return result;
}

}  // namespace agrid::test
