// SPDX-License-Identifier: BSD-3-Clause
#include "tags/basins.h"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

cv::Mat1f randomRelief(std::mt19937& random, int levels) {
  cv::Mat1f relief(17, 23);
  for (float& h : relief) h = static_cast<float>(random() % static_cast<unsigned>(levels));
  return relief;
}

template <typename F>
void forEachPair(const cv::Mat1f& relief, F f) {
  for (int y = 0; y < relief.rows; ++y) {
    for (int x = 0; x < relief.cols; ++x) {
      for (const Pixel step : kNeighbours) {
        const Pixel q = Pixel{x, y} + step;
        if (q.x < 0 || q.y < 0 || q.x >= relief.cols || q.y >= relief.rows) continue;
        f(static_cast<std::size_t>(y * relief.cols + x),
          static_cast<std::size_t>(q.y * relief.cols + q.x));
      }
    }
  }
}

TEST(Basins, EachHasOnePeakThatNoneOfItsPixelsTops) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const cv::Mat1f relief = randomRelief(random, 3 + trial % 7);
    const float* height = relief.ptr<float>();
    const Basins basins = findBasins(relief);
    std::vector<std::size_t> sizes(basins.basins.size(), 0);
    for (std::size_t i = 0; i < relief.total(); ++i) {
      ASSERT_EQ(basins.of_pixel[i] == Basins::kNone, height[i] <= 0);
      if (height[i] <= 0) continue;
      EXPECT_LE(height[i], basins.basins[basins.of_pixel[i]].height);
      ++sizes[basins.of_pixel[i]];
    }
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      EXPECT_EQ(sizes[b], basins.basins[b].size_px);
      EXPECT_EQ(basins.of_pixel[basins.basins[b].peak], b);
      EXPECT_EQ(height[basins.basins[b].peak], basins.basins[b].height);
    }
    forEachPair(relief, [&](std::size_t i, std::size_t j) {
      const std::uint32_t b = basins.of_pixel[i];
      if (b == Basins::kNone || basins.basins[b].peak != i) return;
      EXPECT_LE(height[j], height[i]);
    });
  }
}

TEST(Basins, SaddlesAreTheHighestWaysBetweenThem) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 30; ++trial) {
    const cv::Mat1f relief = randomRelief(random, 4 + trial % 9);
    const float* height = relief.ptr<float>();
    const Basins basins = findBasins(relief);
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> expected;
    forEachPair(relief, [&](std::size_t i, std::size_t j) {
      const std::uint32_t a = basins.of_pixel[i];
      const std::uint32_t b = basins.of_pixel[j];
      if (a == Basins::kNone || b == Basins::kNone || a >= b) return;
      float& highest = expected[{a, b}];
      highest = std::max(highest, std::min(height[i], height[j]));
    });
    ASSERT_EQ(basins.saddles.size(), expected.size());
    for (const Saddle& saddle : basins.saddles) {
      EXPECT_EQ(saddle.height, (expected[{saddle.a, saddle.b}]));
      EXPECT_EQ(height[saddle.pixel], saddle.height);
    }
    EXPECT_TRUE(
        std::is_sorted(basins.saddles.begin(), basins.saddles.end(),
                       [](const Saddle& p, const Saddle& q) { return p.height > q.height; }));
  }
}

TEST(Basins, EachPixelBelongsWithTheOneItRisesToMostSteeply) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 30; ++trial) {
    cv::Mat1f relief = randomRelief(random, 5);
    float next = 1;  // so that there are no plateaus
    for (float& h : relief) h = h > 0 ? h + 1e-4F * next++ : 0;
    const float* height = relief.ptr<float>();
    const Basins basins = findBasins(relief);
    std::vector<std::pair<float, std::size_t>> steepest(relief.total(), {0.F, 0});
    forEachPair(relief, [&](std::size_t i, std::size_t j) {
      const auto columns = static_cast<std::size_t>(relief.cols);
      const bool is_diagonal = i % columns != j % columns && i / columns != j / columns;
      const float rise = (height[j] - height[i]) * (is_diagonal ? 0.70710678F : 1.F);
      if (height[i] > 0 && rise > steepest[i].first) steepest[i] = {rise, j};
    });
    for (std::size_t i = 0; i < steepest.size(); ++i) {
      if (steepest[i].first <= 0) continue;
      EXPECT_EQ(basins.of_pixel[i], basins.of_pixel[steepest[i].second]) << trial << " " << i;
    }
  }
}

TEST(Basins, APlateauIsPartedInItsMiddle) {
  const cv::Mat1f relief = (cv::Mat1f(1, 10) << 5, 3, 3, 3, 3, 3, 3, 4, 6, 6);
  const Basins basins = findBasins(relief);
  EXPECT_EQ(basins.of_pixel, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1, 1, 1}));
}

TEST(Basins, TheSteepestWayUpDecidesDiagonalsBeingLonger) {
  // the middle is 2 below both: 4 straight to the right, 4 across to the upper left
  const cv::Mat1f relief = (cv::Mat1f(3, 3) << 4, 0, 0, 0, 2, 4, 0, 0, 0);
  const Basins basins = findBasins(relief);
  EXPECT_EQ(basins.of_pixel[4], basins.of_pixel[5]);
  EXPECT_NE(basins.of_pixel[4], basins.of_pixel[0]);
}

}  // namespace
}  // namespace agrid
