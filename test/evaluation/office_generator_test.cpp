// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/office_generator.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "agrid/map/occupancy_map.h"

namespace agrid {
namespace {

OfficeParams office(int size, std::uint32_t seed, double resolution = 0.05) {
  OfficeParams params;
  params.size = size;
  params.seed = seed;
  params.resolution = resolution;
  return params;
}

/// Pixels with nothing but free ones within `reach` pixels.
std::vector<bool> clearPixels(const OccupancyGrid& grid, int reach) {
  std::vector<bool> clear(grid.values.size());
  for (std::size_t i = 0; i < clear.size(); ++i) {
    const Pixel p = grid.geometry.pixel(i);
    bool all_free = true;
    for (int dy = -reach; dy <= reach && all_free; ++dy) {
      for (int dx = -reach; dx <= reach && all_free; ++dx) {
        if (dx * dx + dy * dy > reach * reach) continue;
        const Pixel q{p.x + dx, p.y + dy};
        all_free = grid.geometry.contains(q) && grid.values[grid.geometry.index(q)] == 0;
      }
    }
    clear[i] = all_free;
  }
  return clear;
}

/// The rooms that are reached from one pixel over passable ones; takes these away.
std::set<std::uint16_t> flood(const Office& drawn, std::vector<bool>& passable, std::size_t start) {
  const MapGeometry& geometry = drawn.grid.geometry;
  std::set<std::uint16_t> rooms;
  std::vector<std::size_t> stack{start};
  passable[start] = false;
  while (!stack.empty()) {
    const Pixel p = geometry.pixel(stack.back());
    if (drawn.rooms[stack.back()] != 0) rooms.insert(drawn.rooms[stack.back()]);
    stack.pop_back();
    for (const Pixel q :
         {Pixel{p.x + 1, p.y}, Pixel{p.x - 1, p.y}, Pixel{p.x, p.y + 1}, Pixel{p.x, p.y - 1}}) {
      if (!geometry.contains(q) || !passable[geometry.index(q)]) continue;
      passable[geometry.index(q)] = false;
      stack.push_back(geometry.index(q));
    }
  }
  return rooms;
}

/// How many rooms hang together, at most, for a robot of a radius in pixels.
std::size_t roomsTogether(const Office& drawn, int radius_px) {
  std::vector<bool> passable = clearPixels(drawn.grid, radius_px);
  std::size_t most = 0;
  for (std::size_t i = 0; i < passable.size(); ++i) {
    if (passable[i]) most = std::max(most, flood(drawn, passable, i).size());
  }
  return most;
}

std::set<std::uint16_t> allRooms(const Office& drawn) {
  std::set<std::uint16_t> rooms(drawn.rooms.begin(), drawn.rooms.end());
  rooms.erase(0);
  return rooms;
}

/// The rooms half a metre from a door on its two sides; 0: none.
std::pair<int, int> roomsBeside(const Office& drawn, const Segment& door) {
  const Point2 along = (door.b - door.a).normalized();
  const auto room = [&](double distance) {
    const Point2 point = door.midpoint() + distance * Point2(-along.y(), along.x());
    const auto pixel = drawn.grid.geometry.pixelAt(point);
    return pixel ? int{drawn.rooms[drawn.grid.geometry.index(*pixel)]} : 0;
  };
  return {room(0.5), room(-0.5)};
}

TEST(OfficeGenerator, SameSeedSameOffice) {
  const Office a = generateOffice(office(400, 5));
  const Office b = generateOffice(office(400, 5));
  EXPECT_EQ(a.grid.values, b.grid.values);
  EXPECT_EQ(a.rooms, b.rooms);
  EXPECT_NE(a.grid.values, generateOffice(office(400, 6)).grid.values);
}

TEST(OfficeGenerator, SameOfficeOnEveryMachine) {
  // Changes with the drawing only: a change on one machine alone is a broken promise.
  EXPECT_EQ(OccupancyMap(generateOffice(office(300, 1)).grid).digest(), "207107f4e8a9ff45");
}

TEST(OfficeGenerator, DrawsTheSizeAskedForWithThreeValues) {
  for (const int size : {100, 101, 257, 640}) {
    SCOPED_TRACE(size);
    const Office drawn = generateOffice(office(size, 3));
    EXPECT_EQ(drawn.grid.geometry.width, size);
    EXPECT_EQ(drawn.grid.geometry.height, size);
    EXPECT_EQ(drawn.rooms.size(), drawn.grid.values.size());
    const std::set<int> values(drawn.grid.values.begin(), drawn.grid.values.end());
    EXPECT_EQ(values, (std::set<int>{-1, 0, 100}));
  }
}

TEST(OfficeGenerator, RoomsAreNumberedWithoutGaps) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const std::set<std::uint16_t> rooms = allRooms(generateOffice(office(600, seed)));
    ASSERT_FALSE(rooms.empty());
    EXPECT_EQ(*rooms.begin(), 1);
    EXPECT_EQ(*rooms.rbegin(), rooms.size());
  }
}

TEST(OfficeGenerator, TrueDoorsLieBetweenTwoRooms) {
  for (std::uint32_t seed = 0; seed < 90; ++seed) {
    const double resolution = seed % 3 == 0 ? 0.025 : seed % 3 == 1 ? 0.05 : 0.1;
    const Office drawn = generateOffice(office(400, seed, resolution));
    std::vector<Segment> doors = drawn.doors_map;
    doors.insert(doors.end(), drawn.shut_doors_map.begin(), drawn.shut_doors_map.end());
    for (const Segment& door : doors) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " at " << door.midpoint().transpose());
      const auto [left, right] = roomsBeside(drawn, door);
      EXPECT_NE(left, 0);
      EXPECT_NE(right, 0);
      EXPECT_NE(left, right);
      EXPECT_GT(door.length(), 0.65);
      EXPECT_LT(door.length(), 1.95);
    }
  }
}

TEST(OfficeGenerator, OpenDoorsAreFreeAndShutOnesAreNot) {
  std::size_t shut = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    OfficeParams params = office(600, seed);
    params.noise = false;
    params.furniture = false;
    const Office drawn = generateOffice(params);
    const auto value = [&](const Point2& p) {
      return drawn.grid.values[drawn.grid.geometry.index(*drawn.grid.geometry.pixelAt(p))];
    };
    for (const Segment& door : drawn.doors_map) EXPECT_EQ(value(door.midpoint()), 0);
    for (const Segment& door : drawn.shut_doors_map) EXPECT_EQ(value(door.midpoint()), 100);
    shut += drawn.shut_doors_map.size();
  }
  EXPECT_GT(shut, 0U);
}

TEST(OfficeGenerator, RoomsAreConnectedThroughOpenDoors) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    for (const int size : {100, 200, 330, 700}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " size " << size);
      const Office drawn = generateOffice(office(size, seed));
      EXPECT_EQ(roomsTogether(drawn, 0), allRooms(drawn).size());
    }
  }
}

TEST(OfficeGenerator, ARobotGetsIntoEveryRoom) {
  for (std::uint32_t seed = 0; seed < 15; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Office drawn = generateOffice(office(600, seed));
    EXPECT_EQ(roomsTogether(drawn, 5), allRooms(drawn).size());
  }
}

TEST(OfficeGenerator, FurnitureAndNoiseLeaveTheBuildingAsItIs) {
  OfficeParams params = office(500, 8);
  const Office full = generateOffice(params);
  params.furniture = false;
  const Office empty = generateOffice(params);
  params.noise = false;
  const Office clean = generateOffice(params);
  EXPECT_EQ(full.rooms, clean.rooms);
  EXPECT_EQ(full.doors_map.size(), clean.doors_map.size());
  EXPECT_NE(full.grid.values, empty.grid.values);
  EXPECT_NE(empty.grid.values, clean.grid.values);
  for (std::size_t i = 0; i < clean.rooms.size(); ++i) {
    ASSERT_TRUE(clean.rooms[i] == 0 || clean.grid.values[i] == 0) << i;
  }
}

TEST(OfficeGenerator, LargeOfficesHaveManyRooms) {
  const Office drawn = generateOffice(office(3000, 7));
  EXPECT_GT(allRooms(drawn).size(), 300U);
  EXPECT_GT(drawn.doors_map.size(), 300U);
}

TEST(OfficeGenerator, RefusesParametersOutOfRange) {
  for (const int size : {-5, 0, 99, 20001}) {
    EXPECT_THROW(generateOffice(office(size, 1)), std::invalid_argument) << size;
  }
  for (const double resolution : {0.0, -0.05, 0.5, std::nan("")}) {
    EXPECT_THROW(generateOffice(office(600, 1, resolution)), std::invalid_argument) << resolution;
  }
  EXPECT_THROW(generateOffice(office(100, 1, 0.02)), std::invalid_argument) << "2 m";
  EXPECT_THROW(generateOffice(office(20000, 1, 0.1)), std::invalid_argument) << "2 km";
}

}  // namespace
}  // namespace agrid
