// SPDX-License-Identifier: BSD-3-Clause
#include "areas/cell_labels.h"

#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/square_grid.h"

namespace agrid {
namespace {

std::vector<Area> areasWithIds(const std::vector<std::uint32_t>& ids) {
  std::vector<Area> areas(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) areas[i].id = AreaId{ids[i]};
  return areas;
}

TEST(CellLabels, AreThoseOfMostPixelsATieGoingToTheLowestId) {
  const MapGeometry geometry{6, 2, 1, {}};
  const AGrid grid({}, {0, 2, 4, 6}, {0, 2});
  const std::vector<std::uint16_t> labels{2, 1, 0, 0, 0, 0,  //
                                          2, 1, 0, 2, 0, 0};
  const auto cells = labelCells(grid, geometry, labels, areasWithIds({4, 9}));
  EXPECT_EQ(cells, (std::vector<AreaId>{AreaId{4}, AreaId{9}, AreaId{0}}));
}

TEST(CellLabels, AgreeWithACountOfAllPixelsOnATurnedGrid) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    std::uniform_real_distribution<double> value(-3, 3);
    const MapGeometry geometry{40, 30, 0.1, {{value(random), value(random)}, value(random)}};
    const Pose2 image_from_grid{{1.5, -1}, value(random)};
    const AGrid grid(geometry.map_from_image * image_from_grid, {-4, -1, -0.4, 0, 0.3, 1.7, 4},
                     {-4, -2, -1.1, 0.2, 0.9, 4});
    std::vector<std::uint16_t> labels(geometry.pixelCount());
    for (auto& label : labels) label = static_cast<std::uint16_t>(random() % 4);
    std::vector<std::map<std::uint16_t, int>> counts(grid.cellCount());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto cell = grid.cellAt(geometry.center(geometry.pixel(i)));
      if (cell && labels[i] != 0) ++counts[grid.index(*cell)][labels[i]];
    }
    const auto cells = labelCells(grid, geometry, labels, areasWithIds({1, 2, 3}));
    ASSERT_EQ(cells.size(), grid.cellCount());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      std::uint32_t best = 0;
      int most = 0;
      for (const auto& [label, count] : counts[c]) {
        if (count <= most) continue;
        most = count;
        best = label;
      }
      EXPECT_EQ(cells[c], AreaId{best});
    }
  }
}

TEST(CellLabels, CellsOnASegmentAreThoseThatItsPointsLieIn) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> value(-1, 7);
  const AGrid grid({{0.5, -0.25}, 0.7}, {0, 1, 1.5, 4, 6}, {-3, 0, 0.5, 2, 5});
  for (int trial = 0; trial < 100; ++trial) {
    const Segment segment{{value(random), value(random)}, {value(random), value(random)}};
    std::set<std::uint32_t> sampled;
    for (int i = 0; i <= 20000; ++i) {
      const auto cell = grid.cellAt(segment.a + (segment.b - segment.a) * (i / 20000.));
      if (cell) sampled.insert(static_cast<std::uint32_t>(grid.index(*cell)));
    }
    const auto cells = cellsOnSegment(grid, segment);
    EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
    for (const std::uint32_t cell : sampled) {
      EXPECT_TRUE(std::binary_search(cells.begin(), cells.end(), cell));
    }
    EXPECT_LE(cells.size(), sampled.size() + 1) << "at most a corner cut shorter than the samples";
  }
}

TEST(CellLabels, APointLiesInOneCell) {
  const AGrid grid({}, {0, 1, 2}, {0, 1, 2});
  const Segment point{{1.5, 0.5}, {1.5, 0.5}};
  EXPECT_EQ(cellsOnSegment(grid, point), std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace agrid
