// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan_oracle.h"

namespace agrid::test {

inline PlannerParams pointRobot() {
  PlannerParams params;
  params.robot_radius = 0;
  return params;
}

/// Two rooms, a door of three pixels between them, and a third room without a door.
inline Scene threeRooms() {
  Scene scene = sceneOf({"#################",  //
                         "#.......#.......#",  //
                         "#.......#.......#",  //
                         "#...............#",  //
                         "#...............#",  //
                         "#...............#",  //
                         "#.......#.......#",  //
                         "#################",  //
                         "#...............#",  //
                         "#################"});
  scene.areas = {"                 ",  //
                 " AAAAAAA BBBBBBB ",  //
                 " AAAAAAA BBBBBBB ",  //
                 " AAAAAAABBBBBBBB ",  //
                 " AAAAAAABBBBBBBB ",  //
                 " AAAAAAABBBBBBBB ",  //
                 " AAAAAAA BBBBBBB ",  //
                 "                 ",  //
                 " CCCCCCCCCCCCCCC ",  //
                 "                 "};
  scene.x_lines = 5;
  scene.y_lines = 3;
  Door door;
  door.id = DoorId{1};
  door.name = "the door";
  door.areas = {AreaId{1}, AreaId{2}};
  door.width = 3;
  door.jambs_map = {{8.5, 4}, {8.5, 7}};
  scene.doors = {door};
  return scene;
}

inline Plan planIn(const Scene& scene, const PlannerParams& params, const PlanRequest& request) {
  return Planner(mapOf(scene), params).plan(request);
}

}  // namespace agrid::test
