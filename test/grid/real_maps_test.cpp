// SPDX-License-Identifier: BSD-3-Clause
// What the documents say about maps of real buildings, which are no part of this repository.
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "agrid/grid/grid_construction.h"
#include "agrid/map/map_io.h"

namespace agrid {
namespace {

std::string mapFile(const std::string& name) {
  return std::string(AGRID_SHARED) + "/maps/real/" + name + "/map.yaml";
}

Walls wallsOf(const std::string& name, const WallParams& params = {}) {
  return detectWalls(OccupancyMap(loadMap(mapFile(name)).grid), params);
}

struct Row {
  std::string map;
  double cells_paper;
};

class Table1 : public testing::TestWithParam<Row> {};

TEST_P(Table1, CellsAreWithin15PercentOfThePapers) {
  const auto& [map, cells_paper] = GetParam();
  if (!std::filesystem::exists(mapFile(map))) GTEST_SKIP() << mapFile(map) << " is missing";
  const Walls walls = wallsOf(map);
  EXPECT_EQ(walls.map_from_grid.yaw, 0) << "the paper's maps are upright";
  EXPECT_NEAR(static_cast<double>(constructGrid(walls).cellCount()) / cells_paper, 1, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Paper, Table1,
                         testing::Values(Row{"ubremen", 10962}, Row{"fortaphill", 7878},
                                         Row{"hospitalpart", 285}, Row{"intel", 4473},
                                         Row{"freiburg", 4794}, Row{"disb1", 10290}),
                         [](const auto& info) { return info.param.map; });

TEST(RealMaps, TurnedBuildingsGetAGridAlongTheirWalls) {
  if (!std::filesystem::exists(mapFile("g4s_y2"))) GTEST_SKIP() << "../shared is missing";
  constexpr double kDegree = 3.14159265358979 / 180;
  EXPECT_NEAR(wallsOf("g4s_y2").map_from_grid.yaw / kDegree, -41.2, 0.3);
  EXPECT_NEAR(wallsOf("pal_office").map_from_grid.yaw / kDegree, 13.4, 0.3);
  WallParams upright;
  upright.estimate_direction = false;
  EXPECT_EQ(wallsOf("g4s_y2", upright).map_from_grid.yaw, 0);
}

}  // namespace
}  // namespace agrid
