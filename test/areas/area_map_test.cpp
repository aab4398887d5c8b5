// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "agrid/evaluation/office_generator.h"
#include "support/ascii_map.h"
#include "support/segmentation.h"
#include "tags/division.h"
#include "tags/relief.h"

namespace agrid {
namespace {

using test::segment;

OfficeParams officeParams(std::uint32_t seed, bool clutter) {
  OfficeParams params;
  params.size = 360;
  params.seed = seed;
  params.furniture = clutter;
  params.noise = clutter;
  return params;
}

OccupancyMap office(std::uint32_t seed, bool clutter = true) {
  return OccupancyMap(generateOffice(officeParams(seed, clutter)).grid);
}

/// The grid turned by 90 degrees counter-clockwise.
OccupancyGrid turned(const OccupancyGrid& grid) {
  OccupancyGrid result = grid;
  std::swap(result.geometry.width, result.geometry.height);
  for (int y = 0; y < grid.geometry.height; ++y) {
    for (int x = 0; x < grid.geometry.width; ++x) {
      const Pixel p{grid.geometry.height - 1 - y, x};
      result.values[result.geometry.index(p)] = grid.values[grid.geometry.index({x, y})];
    }
  }
  return result;
}

OccupancyGrid doubled(const OccupancyGrid& grid) {
  OccupancyGrid result = grid;
  result.geometry.width *= 2;
  result.geometry.height *= 2;
  result.geometry.resolution /= 2;
  result.values.resize(4 * grid.values.size());
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const Pixel p = result.geometry.pixel(i);
    result.values[i] = grid.values[grid.geometry.index({p.x / 2, p.y / 2})];
  }
  return result;
}

/// Share of the pixels labelled in both whose areas are each other's best partner.
double agreement(const std::vector<std::uint16_t>& a, const std::vector<std::uint16_t>& b) {
  std::map<std::pair<int, int>, std::size_t> common;
  std::map<int, std::pair<std::size_t, int>> best_of_a;
  std::map<int, std::pair<std::size_t, int>> best_of_b;
  std::size_t both = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0 || b[i] == 0) continue;
    ++common[{a[i], b[i]}];
    ++both;
  }
  for (const auto& [pair, count] : common) {
    best_of_a[pair.first] = std::max(best_of_a[pair.first], {count, pair.second});
    best_of_b[pair.second] = std::max(best_of_b[pair.second], {count, pair.first});
  }
  std::size_t agreeing = 0;
  for (const auto& [label, best] : best_of_a) {
    if (best_of_b[best.second].second == label) agreeing += best.first;
  }
  return static_cast<double>(agreeing) / static_cast<double>(both);
}

class Offices : public ::testing::TestWithParam<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Offices, ::testing::Range(1U, 9U));

TEST_P(Offices, LabelsLieOnFreePixelsAndNameAreas) {
  const OccupancyMap map = office(GetParam());
  const AreaMap areas = segment(map);
  ASSERT_EQ(areas.pixel_labels.size(), map.pixels().size());
  std::vector<std::size_t> sizes(areas.areas.size() + 1, 0);
  for (std::size_t i = 0; i < areas.pixel_labels.size(); ++i) {
    ASSERT_LE(areas.pixel_labels[i], areas.areas.size());
    if (areas.pixel_labels[i] != 0) {
      ASSERT_EQ(map.pixels()[i], Occupancy::kFree);
    }
    ++sizes[areas.pixel_labels[i]];
  }
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    EXPECT_NEAR(areas.areas[k - 1].size, static_cast<double>(sizes[k]) * 0.05 * 0.05, 1e-9);
    EXPECT_GE(areas.areas[k - 1].size, AreaParams().min_island_size * 0.8);
    EXPECT_EQ(areas.areas[k - 1].id, AreaId{static_cast<std::uint32_t>(k)});
  }
}

TEST_P(Offices, EachAreaIsConnected) {
  // with clutter an area may be cut by what stands in it; without it must hang together
  const OccupancyMap map = office(GetParam(), false);
  const AreaMap areas = segment(map);
  cv::Mat1w labels(map.geometry().height, map.geometry().width);
  std::copy(areas.pixel_labels.begin(), areas.pixel_labels.end(), labels.begin());
  for (std::size_t k = 1; k <= areas.areas.size(); ++k) {
    cv::Mat1b mask;
    cv::compare(labels, static_cast<double>(k), mask, cv::CMP_EQ);
    cv::Mat1i parts;
    EXPECT_EQ(cv::connectedComponents(mask, parts, 8, CV_32S), 2) << areas.areas[k - 1].name;
  }
}

TEST_P(Offices, AnchorsAndOutlinesBelongToTheirAreas) {
  const OccupancyMap map = office(GetParam());
  const AreaMap areas = segment(map);
  for (std::size_t k = 0; k < areas.areas.size(); ++k) {
    const Area& area = areas.areas[k];
    const auto anchor = map.geometry().pixelAt(area.anchor_map);
    ASSERT_TRUE(anchor);
    EXPECT_EQ(areas.pixel_labels[map.geometry().index(*anchor)], k + 1);
    EXPECT_GT(area.anchor_clearance, 0);
    ASSERT_GE(area.outline_map.size(), 3U);
    double twice_area = 0;
    for (std::size_t i = 0; i < area.outline_map.size(); ++i) {
      const Point2& p = area.outline_map[i];
      const Point2& q = area.outline_map[(i + 1) % area.outline_map.size()];
      twice_area += p.x() * q.y() - p.y() * q.x();
    }
    EXPECT_GT(twice_area, 0) << "counter-clockwise";
    // what hangs on by a corner only lies outside, which matters for small areas
    if (area.size > 2) {
      EXPECT_GT(twice_area / 2, 0.9 * area.size);
    }
  }
}

TEST_P(Offices, DoorsJoinTwoAreasOnFreeGround) {
  const OccupancyMap map = office(GetParam());
  const AreaMap areas = segment(map);
  const AGrid grid = test::squareGrid(map.geometry(), 1);
  EXPECT_GT(areas.doors.size(), 0U);
  for (const Door& door : areas.doors) {
    EXPECT_LT(door.areas[0], door.areas[1]);
    EXPECT_GT(door.areas[0], AreaId{0});
    EXPECT_LE(static_cast<std::size_t>(door.areas[1]), areas.areas.size());
    EXPECT_GE(door.confidence, 0);
    EXPECT_LE(door.confidence, 1);
    EXPECT_NEAR(door.width, door.jambs_map.length(), 1e-12);
    ASSERT_FALSE(door.cells.empty());
    EXPECT_TRUE(std::is_sorted(door.cells.begin(), door.cells.end()));
    const auto cell = grid.cellAt(door.jambs_map.midpoint());
    ASSERT_TRUE(cell);
    EXPECT_TRUE(std::binary_search(door.cells.begin(), door.cells.end(), grid.index(*cell)));
  }
}

TEST_P(Offices, CellsBearTheAreaOfMostOfTheirPixels) {
  const OccupancyMap map = office(GetParam());
  const AreaMap areas = segment(map);
  const AGrid grid = test::squareGrid(map.geometry(), 1);
  std::vector<std::map<int, int>> counts(grid.cellCount());
  for (std::size_t i = 0; i < areas.pixel_labels.size(); ++i) {
    if (areas.pixel_labels[i] == 0) continue;
    const auto cell = grid.cellAt(map.geometry().center(map.geometry().pixel(i)));
    ++counts[grid.index(cell.value())][areas.pixel_labels[i]];
  }
  ASSERT_EQ(areas.cell_areas.size(), grid.cellCount());
  for (std::size_t c = 0; c < counts.size(); ++c) {
    std::pair<int, int> best{0, 0};
    for (const auto& [label, count] : counts[c]) {
      if (count > best.first) best = {count, label};
    }
    EXPECT_EQ(areas.cell_areas[c], AreaId{static_cast<std::uint32_t>(best.second)});
  }
}

TEST_P(Offices, SeedingWithTheProposalsGivesTheDivision) {
  const OccupancyMap map = office(GetParam());
  const AreaMap areas = segment(map);
  const Division division = divide(makeRelief(map, {}, {}), map.geometry().resolution, {});
  const Basins& basins = division.basins;
  const auto& area_of = division.area_of;
  std::map<std::uint32_t, std::uint16_t> label_of;
  std::set<std::uint16_t> labels;
  for (std::size_t i = 0; i < areas.pixel_labels.size(); ++i) {
    if (areas.pixel_labels[i] == 0) continue;
    const std::uint32_t area = area_of[basins.of_pixel[i]];
    EXPECT_GE(basins.basins[area].height * 0.05, AreaParams().min_area_clearance);
    EXPECT_EQ(label_of.emplace(area, areas.pixel_labels[i]).first->second, areas.pixel_labels[i]);
    labels.insert(areas.pixel_labels[i]);
  }
  EXPECT_EQ(labels.size(), label_of.size());
}

TEST_P(Offices, NoAreaCrossesAClosedDoor) {
  const OccupancyMap map = office(GetParam());
  const AreaMap before = segment(map);
  std::vector<Tag> tags;
  for (const Door& door : before.doors) {
    if (door.width < 0.3) continue;
    DoorTag tag;
    const Point2 way = door.jambs_map.b - door.jambs_map.a;
    tag.pose_map = {door.jambs_map.midpoint(), std::atan2(-way.x(), way.y())};
    tag.width = door.width;
    tag.id = DoorId{static_cast<std::uint32_t>(100 + tags.size())};
    tag.source = TagSource::kManual;
    tags.emplace_back(tag);
  }
  const AreaMap after = segment(map, tags);
  const Relief relief = makeRelief(map, tags, {});
  cv::Mat1i portions;
  cv::connectedComponents(relief.free_space, portions, 8, CV_32S);
  std::map<std::uint16_t, int> portion_of;
  for (std::size_t i = 0; i < after.pixel_labels.size(); ++i) {
    const int portion = portions.ptr<int>()[i];
    if (after.pixel_labels[i] == 0 || portion == 0) continue;
    EXPECT_EQ(portion_of.emplace(after.pixel_labels[i], portion).first->second, portion);
  }
  std::size_t given = 0;
  for (const Door& door : after.doors) given += door.source == TagSource::kManual ? 1 : 0;
  EXPECT_GE(given, tags.size() - 1);
}

TEST_P(Offices, TurningTheMapTurnsTheAreas) {
  const Office plan = generateOffice(officeParams(GetParam(), false));
  const OccupancyMap map(plan.grid);
  const OccupancyMap turned_map(turned(plan.grid));
  const AreaMap areas = segment(map);
  const AreaMap turned_areas = segment(turned_map);
  EXPECT_EQ(areas.areas.size(), turned_areas.areas.size());
  EXPECT_EQ(areas.doors.size(), turned_areas.doors.size());
  std::vector<std::uint16_t> turned_back;
  for (std::size_t i = 0; i < areas.pixel_labels.size(); ++i) {
    const Pixel p = map.geometry().pixel(i);
    turned_back.push_back(
        turned_areas
            .pixel_labels[turned_map.geometry().index({map.geometry().height - 1 - p.y, p.x})]);
  }
  EXPECT_GT(agreement(areas.pixel_labels.vector(), turned_back), 0.995);
}

TEST_P(Offices, HalfTheResolutionGivesTheSameAreas) {
  const Office plan = generateOffice(officeParams(GetParam(), false));
  const AreaMap coarse = segment(OccupancyMap(plan.grid));
  const OccupancyMap fine_map(doubled(plan.grid));
  const AreaMap fine = segment(fine_map);
  EXPECT_EQ(coarse.areas.size(), fine.areas.size());
  std::vector<std::uint16_t> sampled;
  for (std::size_t i = 0; i < coarse.pixel_labels.size(); ++i) {
    const Pixel p = plan.grid.geometry.pixel(i);
    sampled.push_back(fine.pixel_labels[fine_map.geometry().index({2 * p.x, 2 * p.y})]);
  }
  EXPECT_GT(agreement(coarse.pixel_labels.vector(), sampled), 0.98);
}

TEST_P(Offices, ThePoseOfTheMapMovesNothingInIt) {
  Office plan = generateOffice(officeParams(GetParam(), true));
  const AreaMap areas = segment(OccupancyMap(plan.grid));
  const Pose2 moved_from_map{{-12.5, 7.25}, 2.1};
  plan.grid.geometry.map_from_image = moved_from_map * plan.grid.geometry.map_from_image;
  const AreaMap moved = segment(OccupancyMap(plan.grid));
  // only the numbers may differ: they follow the position in the map frame
  EXPECT_EQ(areas.areas.size(), moved.areas.size());
  EXPECT_EQ(agreement(areas.pixel_labels.vector(), moved.pixel_labels.vector()), 1);
  ASSERT_EQ(areas.doors.size(), moved.doors.size());
  for (const Door& door : areas.doors) {
    const Point2 expected = moved_from_map * door.jambs_map.midpoint();
    EXPECT_TRUE(std::any_of(moved.doors.begin(), moved.doors.end(), [&](const Door& d) {
      return (d.jambs_map.midpoint() - expected).norm() < 1e-9;
    }));
  }
}

TEST(AreaMap, DoesNotDependOnTheNumberOfThreads) {
  const OccupancyMap map = office(3);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const AreaMap one = segment(map);
  cv::setNumThreads(2);
  const AreaMap two = segment(map);
  cv::setNumThreads(threads);
  EXPECT_EQ(one.pixel_labels, two.pixel_labels);
  ASSERT_EQ(one.doors.size(), two.doors.size());
  for (std::size_t d = 0; d < one.doors.size(); ++d) {
    EXPECT_EQ(one.doors[d].jambs_map.a, two.doors[d].jambs_map.a);
    EXPECT_EQ(one.doors[d].confidence, two.doors[d].confidence);
  }
}

}  // namespace
}  // namespace agrid
