// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/map/occupancy_map.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/memory.h"

namespace agrid {
namespace {

using test::asciiGrid;
using test::asciiMap;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

OccupancyGrid gridOf(int width, int height, std::size_t count) {
  OccupancyGrid grid;
  grid.geometry = {width, height, 0.05, {}};
  grid.values.assign(count, 0);
  return grid;
}

MapErrorCode codeOf(const OccupancyGrid& grid, const MapParams& params = {}) {
  try {
    const OccupancyMap map(grid, params);
  } catch (const MapError& error) {
    EXPECT_GT(std::string(error.what()).size(), 20u);
    return error.code();
  }
  ADD_FAILURE() << "accepted";
  return MapErrorCode::kFrame;
}

std::string messageOf(const OccupancyGrid& grid) {
  try {
    const OccupancyMap map(grid);
  } catch (const MapError& error) {
    return error.what();
  }
  return {};
}

TEST(OccupancyMap, ClassifiesByTheBounds) {
  OccupancyGrid grid = gridOf(7, 1, 0);
  grid.values = {0, 25, 26, 64, 65, 100, -1};
  const OccupancyMap map(grid);
  const std::vector<Occupancy> expected = {
      Occupancy::kFree,     Occupancy::kFree,     Occupancy::kUnknown, Occupancy::kUnknown,
      Occupancy::kOccupied, Occupancy::kOccupied, Occupancy::kUnknown};
  EXPECT_EQ(map.pixels(), expected);
  EXPECT_TRUE(map.warnings().empty());
  EXPECT_EQ(map.geometry().width, 7);
}

TEST(OccupancyMap, BoundsAreParameters) {
  OccupancyGrid grid = gridOf(4, 1, 0);
  grid.values = {0, 1, 49, 50};
  MapParams params;
  params.free_max = 0;
  params.occupied_min = 50;
  const std::vector<Occupancy> expected = {Occupancy::kFree, Occupancy::kUnknown,
                                           Occupancy::kUnknown, Occupancy::kOccupied};
  EXPECT_EQ(OccupancyMap(grid, params).pixels(), expected);
}

TEST(OccupancyMap, RefusesImpossibleBounds) {
  const OccupancyGrid grid = gridOf(1, 1, 1);
  for (const auto& [free_max, occupied_min] :
       {std::pair{-1, 65}, {100, 101}, {65, 65}, {70, 65}, {25, 101}}) {
    MapParams params;
    params.free_max = free_max;
    params.occupied_min = occupied_min;
    EXPECT_THROW(OccupancyMap(grid, params), std::invalid_argument);
  }
  MapParams params;
  params.max_pixels = kNan;
  EXPECT_THROW(OccupancyMap(grid, params), std::invalid_argument);
}

TEST(OccupancyMap, RowZeroIsTheLowest) {
  const OccupancyMap map = asciiMap({"#.?", "..."});
  EXPECT_TRUE(map.isFree({0, 0}));
  EXPECT_EQ(map.at({0, 1}), Occupancy::kOccupied);
  EXPECT_EQ(map.at({2, 1}), Occupancy::kUnknown);
}

TEST(MapOnTheWire, M1_DataShorterThanSize) {
  EXPECT_EQ(codeOf(gridOf(10, 7, 69)), MapErrorCode::kSize);
  EXPECT_NE(messageOf(gridOf(10, 7, 69)).find("69"), std::string::npos);
  EXPECT_NE(messageOf(gridOf(10, 7, 69)).find("70"), std::string::npos);
}

TEST(MapOnTheWire, M2_DataLongerThanSize) {
  EXPECT_EQ(codeOf(gridOf(10, 7, 71)), MapErrorCode::kSize);
}

TEST(MapOnTheWire, M3_EmptyMaps) {
  EXPECT_EQ(codeOf(gridOf(0, 0, 0)), MapErrorCode::kSize);
  EXPECT_EQ(codeOf(gridOf(0, 5, 0)), MapErrorCode::kSize);
  EXPECT_EQ(codeOf(gridOf(5, 0, 0)), MapErrorCode::kSize);
  EXPECT_EQ(codeOf(gridOf(-5, -1, 5)), MapErrorCode::kSize);
  EXPECT_EQ(codeOf(gridOf(5, 5, 0)), MapErrorCode::kSize);
}

TEST(MapOnTheWire, M4_OneRowOrColumn) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}}) {
    const OccupancyMap map(gridOf(width, height, static_cast<std::size_t>(width * height)));
    EXPECT_EQ(map.pixels().size(), static_cast<std::size_t>(width * height));
  }
}

TEST(MapOnTheWire, M5_HugeSizesAreRefusedBeforeAllocation) {
  constexpr int kMax = std::numeric_limits<int>::max();
  const test::MemoryGrowth growth;
  EXPECT_EQ(codeOf(gridOf(65536, 65536, 0)), MapErrorCode::kCap);
  EXPECT_EQ(codeOf(gridOf(kMax, 1, 0)), MapErrorCode::kCap);
  EXPECT_EQ(codeOf(gridOf(kMax, kMax, 0)), MapErrorCode::kCap);
  EXPECT_LT(growth.bytes(), 1u << 20);
}

TEST(MapOnTheWire, M5_CapIsAParameter) {
  MapParams params;
  params.max_pixels = 70;
  EXPECT_EQ(OccupancyMap(gridOf(10, 7, 70), params).pixels().size(), 70u);
  EXPECT_EQ(codeOf(gridOf(71, 1, 71), params), MapErrorCode::kCap);
}

TEST(MapOnTheWire, M6_Resolution) {
  for (const double resolution :
       {0.0, -0.0, -1.0, kNan, kInf, -kInf, 5e-324, 1e-9, 1e9, 0.00099, 10.01}) {
    OccupancyGrid grid = gridOf(2, 2, 4);
    grid.geometry.resolution = resolution;
    EXPECT_EQ(codeOf(grid), MapErrorCode::kResolution) << resolution;
  }
  for (const double resolution : {0.001, 0.05, 10.0}) {
    OccupancyGrid grid = gridOf(2, 2, 4);
    grid.geometry.resolution = resolution;
    EXPECT_EQ(OccupancyMap(grid).geometry().resolution, resolution);
  }
}

TEST(MapOnTheWire, M7_Origin) {
  for (const double value : {kNan, kInf, -kInf, 1.000001e6, -1.000001e6, 1e308}) {
    OccupancyGrid grid = gridOf(2, 2, 4);
    grid.geometry.map_from_image.position = Point2(value, 0);
    EXPECT_EQ(codeOf(grid), MapErrorCode::kOrigin) << value;
    grid.geometry.map_from_image.position = Point2(0, value);
    EXPECT_EQ(codeOf(grid), MapErrorCode::kOrigin) << value;
  }
  OccupancyGrid grid = gridOf(2, 2, 4);
  grid.geometry.map_from_image.position = Point2(-1e6, 1e6);
  EXPECT_NO_THROW(OccupancyMap{grid});
  for (const double yaw : {kNan, kInf}) {
    grid.geometry.map_from_image.yaw = yaw;
    EXPECT_EQ(codeOf(grid), MapErrorCode::kOrigin) << yaw;
  }
}

TEST(MapOnTheWire, M11_AnyFiniteYawIsKept) {
  for (const double yaw : {-0.7, 3.0, 7.0, -100.0}) {
    const OccupancyMap map = asciiMap({"#."}, 0.5, {Point2(1, 2), yaw});
    const Pixel wall{0, 0};
    EXPECT_EQ(map.geometry().map_from_image.yaw, yaw);
    EXPECT_EQ(map.geometry().pixelAt(map.geometry().center(wall)), wall);
  }
}

TEST(MapOnTheWire, M13_OddValuesAreUnknownAndCounted) {
  OccupancyGrid grid = gridOf(6, 1, 0);
  grid.values = {-2, 101, -128, 127, 0, 100};
  const OccupancyMap map(grid);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(map.at({x, 0}), Occupancy::kUnknown);
  EXPECT_EQ(map.at({4, 0}), Occupancy::kFree);
  EXPECT_EQ(map.at({5, 0}), Occupancy::kOccupied);
  ASSERT_EQ(map.warnings().size(), 1u);
  EXPECT_EQ(map.warnings()[0].substr(0, 2), "4 ");
  MapParams strict;
  strict.strict_values = true;
  EXPECT_EQ(codeOf(grid, strict), MapErrorCode::kValue);
}

TEST(MapOnTheWire, M14_UniformMaps) {
  for (const int value : {-1, 0, 100}) {
    OccupancyGrid grid = gridOf(1000, 1000, 0);
    grid.values.assign(1000 * 1000, static_cast<std::int8_t>(value));
    const OccupancyMap map(grid);
    const Occupancy expected = value < 0    ? Occupancy::kUnknown
                               : value == 0 ? Occupancy::kFree
                                            : Occupancy::kOccupied;
    EXPECT_EQ(map.pixels(), std::vector<Occupancy>(1000 * 1000, expected));
    EXPECT_TRUE(map.warnings().empty());
  }
}

TEST(MapDigest, IsTheSameOnEveryMachine) {
  EXPECT_EQ(asciiMap({"#.?.#.?.#", "........."}, 0.05, {Point2(-1.5, 2.25), 0.7}).digest(),
            "2611a95bd841c2f6");
}

TEST(MapDigest, DependsOnGeometryAndPixelsOnly) {
  const OccupancyGrid grid = asciiGrid({"#..", "..?"}, 0.5, {Point2(0, 2), 0.5});
  const std::string digest = OccupancyMap(grid).digest();
  OccupancyGrid same = grid;
  same.values[0] = 20;  // free as before
  same.geometry.map_from_image.position.x() = -0.0;
  EXPECT_EQ(OccupancyMap(same).digest(), digest);

  std::set<std::string> digests = {digest};
  const auto expectNew = [&digests](const OccupancyGrid& changed) {
    EXPECT_TRUE(digests.insert(OccupancyMap(changed).digest()).second);
  };
  OccupancyGrid changed = grid;
  std::swap(changed.geometry.width, changed.geometry.height);
  expectNew(changed);
  for (double* field : {&changed.geometry.resolution, &changed.geometry.map_from_image.yaw,
                        &changed.geometry.map_from_image.position.x(),
                        &changed.geometry.map_from_image.position.y()}) {
    changed = grid;
    *field += 1e-9;
    expectNew(changed);
  }
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    changed = grid;
    changed.values[i] = static_cast<std::int8_t>(grid.values[i] == 100 ? 0 : 100);
    expectNew(changed);
  }
}

TEST(MapDigest, TellsRandomNeighboursApart) {
  std::mt19937 random(7);
  std::set<std::string> digests;
  OccupancyGrid grid = gridOf(100, 50, 5000);
  for (int i = 0; i < 300; ++i) {
    const std::size_t where = random() % 5000;
    grid.values[where] = static_cast<std::int8_t>(grid.values[where] == 0 ? 100 : 0);
    const std::string digest = OccupancyMap(grid).digest();
    EXPECT_EQ(digest.size(), 16u);
    EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_TRUE(digests.insert(digest).second);
  }
}

}  // namespace
}  // namespace agrid
