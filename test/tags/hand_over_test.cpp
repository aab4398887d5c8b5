// SPDX-License-Identifier: BSD-3-Clause
#include "tags/hand_over.h"

#include <random>

#include <gtest/gtest.h>

#include "tags/basins.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

constexpr std::uint32_t kNone = Basins::kNone;

/// How many steps over open pixels lead from each pixel to a label, or -1 (slow: one round a step).
std::vector<int> stepsTo(std::uint32_t label, const std::vector<std::uint32_t>& before,
                         const std::vector<bool>& is_open, const MapGeometry& geometry) {
  std::vector<int> steps(before.size(), -1);
  for (std::size_t i = 0; i < before.size(); ++i) steps[i] = before[i] == label ? 0 : -1;
  for (int round = 1; round < static_cast<int>(before.size()); ++round) {
    bool has_grown = false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!is_open[i] || before[i] != kNone || steps[i] >= 0) continue;
      for (const Pixel step : kNeighbours) {
        const Pixel q = geometry.pixel(i) + step;
        if (!geometry.contains(q) || steps[geometry.index(q)] != round - 1) continue;
        steps[i] = round;
        has_grown = true;
      }
    }
    if (!has_grown) break;
  }
  return steps;
}

TEST(HandOver, OpenPixelsGoToTheNearestRegionOverThem) {
  std::mt19937 random(11);
  const MapGeometry geometry{13, 11, 1, {}};
  for (int run = 0; run < 40; ++run) {
    std::vector<std::uint32_t> labels(geometry.pixelCount(), kNone);
    std::vector<bool> is_open(labels.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (random() % 12 == 0) labels[i] = static_cast<std::uint32_t>(random() % 3);
      is_open[i] = random() % 2 == 0;
      if (is_open[i]) open.push_back(i);
    }
    const auto before = labels;
    handOver(open, geometry, labels);
    std::vector<std::vector<int>> steps;
    for (std::uint32_t label = 0; label < 3; ++label) {
      steps.push_back(stepsTo(label, before, is_open, geometry));
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (before[i] != kNone || !is_open[i]) {
        EXPECT_EQ(labels[i], before[i]);
        continue;
      }
      int nearest = -1;
      for (const auto& of_label : steps) {
        if (of_label[i] >= 0 && (nearest < 0 || of_label[i] < nearest)) nearest = of_label[i];
      }
      ASSERT_EQ(labels[i] == kNone, nearest < 0);
      if (nearest >= 0) {
        EXPECT_EQ(steps[labels[i]][i], nearest);
      }
    }
  }
}

TEST(HandOver, WithoutOpenPixelsNothingChanges) {
  std::vector<std::uint32_t> labels{0, kNone, 1};
  handOver({}, {3, 1, 1, {}}, labels);
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{0, kNone, 1}));
}

}  // namespace
}  // namespace agrid
