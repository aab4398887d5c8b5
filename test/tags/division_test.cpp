// SPDX-License-Identifier: BSD-3-Clause
#include "tags/division.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"

namespace agrid {
namespace {

OccupancyMap office(std::uint32_t seed) {
  OfficeParams params;
  params.size = 400;
  params.seed = seed;
  return OccupancyMap(generateOffice(params).grid);
}

Division divide(const OccupancyMap& map, AreaMethod method) {
  AreaParams params;
  params.method = method;
  return agrid::divide(makeRelief(map, {}, params), map.geometry().resolution, params);
}

TEST(Division, EachAreaIsNamedByItsHighestBasin) {
  for (const AreaMethod method : {AreaMethod::kBorders, AreaMethod::kPersistence}) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      const Division division = divide(office(seed), method);
      const auto& basins = division.basins.basins;
      ASSERT_EQ(division.area_of.size(), basins.size());
      std::set<std::uint32_t> areas;
      for (std::uint32_t i = 0; i < basins.size(); ++i) {
        const std::uint32_t area = division.area_of[i];
        areas.insert(area);
        EXPECT_EQ(division.area_of[area], area);
        EXPECT_GE(basins[area].height, basins[i].height);
      }
      EXPECT_GT(areas.size(), 3U);
      EXPECT_LT(areas.size(), basins.size());
    }
  }
}

TEST(Division, OnlyBordersCutAtOpenings) {
  const OccupancyMap map = office(1);
  EXPECT_FALSE(divide(map, AreaMethod::kBorders).openings.all.empty());
  EXPECT_TRUE(divide(map, AreaMethod::kPersistence).openings.all.empty());
}

TEST(Division, ThePaperHasNone) {
  const Division division = divide(office(1), AreaMethod::kPaper);
  EXPECT_TRUE(division.basins.of_pixel.empty());
  EXPECT_TRUE(division.area_of.empty());
}

TEST(Division, TheSameMapIsDividedTheSameWay) {
  const OccupancyMap map = office(2);
  const Division first = divide(map, AreaMethod::kBorders);
  const Division second = divide(map, AreaMethod::kBorders);
  EXPECT_EQ(first.basins.of_pixel, second.basins.of_pixel);
  EXPECT_EQ(first.area_of, second.area_of);
}

}  // namespace
}  // namespace agrid
