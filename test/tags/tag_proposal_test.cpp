// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/tag_proposal.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/ascii_map.h"

namespace agrid {
namespace {

OccupancyMap twoRooms(const Pose2& map_from_image = {}) {
  std::vector<std::string> rows(24, "#....................#....................#");
  rows.front() = rows.back() = std::string(43, '#');
  for (std::size_t r = 10; r < 14; ++r) rows[r][21] = '.';
  return test::asciiMap(rows, 0.2, map_from_image);
}

std::vector<AreaTag> areaTags(const std::vector<Tag>& tags) {
  std::vector<AreaTag> areas;
  for (const Tag& tag : tags) {
    if (const auto* area = std::get_if<AreaTag>(&tag)) areas.push_back(*area);
  }
  return areas;
}

std::vector<DoorTag> doorTags(const std::vector<Tag>& tags) {
  std::vector<DoorTag> doors;
  for (const Tag& tag : tags) {
    if (const auto* door = std::get_if<DoorTag>(&tag)) doors.push_back(*door);
  }
  return doors;
}

TEST(TagProposal, PutsASeedIntoEachRoomFarFromItsWalls) {
  const auto seeds = areaTags(proposeTags(twoRooms(), {}));
  ASSERT_EQ(seeds.size(), 2U);
  EXPECT_EQ(seeds[0].id, AreaId{1});
  EXPECT_EQ(seeds[1].id, AreaId{2});
  for (const AreaTag& seed : seeds) {
    EXPECT_TRUE(seed.name.empty());
    EXPECT_EQ(seed.source, TagSource::kAutomatic);
    EXPECT_NEAR(seed.seed_map.y(), 2.4, 0.3);
  }
  EXPECT_NEAR(std::abs(seeds[0].seed_map.x() - seeds[1].seed_map.x()), 4.2, 0.5);
}

TEST(TagProposal, SaysNothingAboutAreasThatAreTagged) {
  AreaTag given;
  given.id = AreaId{1};
  given.seed_map = {1, 1};
  const auto seeds = areaTags(proposeTags(twoRooms(), {given}));
  ASSERT_EQ(seeds.size(), 1U);
  EXPECT_EQ(seeds[0].id, AreaId{2}) << "1 is taken";
  EXPECT_GT(seeds[0].seed_map.x(), 4.2);
}

TEST(TagProposal, SeedsBothSidesOfAGivenDoor) {
  DoorTag door;
  door.pose_map = {{2.1, 2.4}, 0};
  EXPECT_EQ(areaTags(proposeTags(twoRooms(), {door})).size(), 3U);
}

TEST(TagProposal, FindsThePapersPassageAndCentroids) {
  AreaParams params;
  params.method = AreaMethod::kPaper;
  for (const double yaw : {0., 0.8}) {
    const Pose2 pose{{3, -2}, yaw};
    const auto tags = proposeTags(twoRooms(pose), {}, params);
    const auto doors = doorTags(tags);
    ASSERT_EQ(doors.size(), 1U);
    EXPECT_EQ(doors[0].id, DoorId{1});
    EXPECT_NEAR(doors[0].width, 0.8, 1e-9);
    EXPECT_NEAR((doors[0].pose_map.position - pose * Point2(4.3, 2.4)).norm(), 0, 1e-9);
    EXPECT_NEAR(std::abs(std::cos(doors[0].pose_map.yaw - yaw)), 1, 1e-9);
    const auto seeds = areaTags(tags);
    ASSERT_EQ(seeds.size(), 2U);
    for (const AreaTag& seed : seeds) {
      const Point2 in_image = inverse(pose) * seed.seed_map;
      EXPECT_NEAR(in_image.y(), 2.4, 0.2);
      EXPECT_NEAR(std::abs(in_image.x() - 4.3), 2.1, 0.2);
    }
  }
}

TEST(TagProposal, LeavesPassagesThatAreTooWideSlantedOrLonely) {
  AreaParams params;
  params.method = AreaMethod::kPaper;
  const auto count = [&] { return doorTags(proposeTags(twoRooms(), {}, params)).size(); };
  EXPECT_EQ(count(), 1U);
  params.passages.max_width = 0.7;
  EXPECT_EQ(count(), 0U);
  params.passages.max_width = 1.3;
  params.passages.min_support = 5;
  EXPECT_EQ(count(), 0U);
}

TEST(TagProposal, RefusesParametersOutOfRange) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  for (double AreaParams::*const field :
       {&AreaParams::max_clutter_diagonal, &AreaParams::min_island_size, &AreaParams::merge_ratio,
        &AreaParams::min_prominence, &AreaParams::min_area_size, &AreaParams::min_area_clearance,
        &AreaParams::max_door_width, &AreaParams::min_border_length}) {
    for (const double value : {-1., 1e9, kNan}) {
      AreaParams params;
      params.*field = value;
      EXPECT_THROW(proposeTags(twoRooms(), {}, params), std::invalid_argument);
    }
  }
  for (double PassageParams::*const field :
       {&PassageParams::min_width, &PassageParams::max_width, &PassageParams::max_skew_deg,
        &PassageParams::min_spacing, &PassageParams::support_reach, &PassageParams::min_support,
        &PassageParams::opening}) {
    for (const double value : {-1., 1e9, kNan}) {
      AreaParams params;
      params.passages.*field = value;
      EXPECT_THROW(validate(params), std::invalid_argument);
    }
  }
}

TEST(TagProposal, NamesTheParameterAndItsBounds) {
  AreaParams params;
  params.merge_ratio = 1.5;
  try {
    validate(params);
    FAIL() << "1.5 was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "AreaParams::merge_ratio is 1.5, must lie in [0.001, 1]");
  }
}

}  // namespace
}  // namespace agrid
