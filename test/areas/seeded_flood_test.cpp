// SPDX-License-Identifier: BSD-3-Clause
#include "areas/seeded_flood.h"

#include <gtest/gtest.h>

namespace agrid {
namespace {

constexpr std::uint32_t kNone = Basins::kNone;

/// A relief of one row; each digit is the height of a pixel.
Basins basinsOf(const std::string& heights) {
  cv::Mat1f relief(1, static_cast<int>(heights.size()));
  for (int x = 0; x < relief.cols; ++x) {
    relief(0, x) = static_cast<float>(heights[static_cast<std::size_t>(x)] - '0');
  }
  return findBasins(relief);
}

std::vector<std::uint32_t> flood(const std::string& heights,
                                 const std::vector<std::uint32_t>& area_of,
                                 const std::vector<std::size_t>& seeds) {
  return floodFromSeeds(basinsOf(heights), area_of, seeds, static_cast<int>(heights.size()));
}

TEST(SeededFlood, KeepsSeedsOfDifferentAreasApart) {
  EXPECT_EQ(flood("13512521", {0, 1}, {1, 6}),
            (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(SeededFlood, FloodsItsOwnAreaBeforeAnyOther) {
  // basins 0, 1, 2; the way from 1 to 2 is higher, but 0 and 1 belong together
  EXPECT_EQ(flood("525363", {0, 0, 2}, {0, 4}), (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}));
}

TEST(SeededFlood, GivesAnAreaWithoutSeedToTheNeighbourItOpensToTheWidest) {
  EXPECT_EQ(flood("614363", {0, 1, 2}, {0, 4}), (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1}));
}

TEST(SeededFlood, LeavesWhatNoSeedReaches) {
  EXPECT_EQ(flood("12021", {0, 1}, {0}), (std::vector<std::uint32_t>{0, 0, kNone, kNone, kNone}));
}

TEST(SeededFlood, SplitsABasinByTheWayToItsSeeds) {
  EXPECT_EQ(flood("1234567", {0}, {5, 0}), (std::vector<std::uint32_t>{1, 1, 1, 0, 0, 0, 0}));
}

TEST(SeededFlood, SplitsAnAreaOfSeveralBasinsAtTheLowestWay) {
  // basins 0, 1, 2 of one area, seeds in the outer ones: the cut is at the lower saddle
  EXPECT_EQ(flood("624354", {0, 0, 0}, {0, 4}), (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace agrid
