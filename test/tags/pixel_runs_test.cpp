// SPDX-License-Identifier: BSD-3-Clause
#include "tags/pixel_runs.h"

#include <map>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace agrid {
namespace {

cv::Mat1b randomImage(std::mt19937& random, unsigned one_in) {
  cv::Mat1b image(1 + static_cast<int>(random() % 25), 1 + static_cast<int>(random() % 35));
  for (std::uint8_t& pixel : image) pixel = random() % one_in == 0 ? 1 : 0;
  return image;
}

TEST(PixelRuns, CoverThePixelsOfOneValueAndAreAsLongAsCanBe) {
  std::mt19937 random(1);
  for (unsigned trial = 0; trial < 60; ++trial) {
    const cv::Mat1b image = randomImage(random, 2 + trial % 4);
    for (const auto value : {std::uint8_t{0}, std::uint8_t{1}}) {
      cv::Mat1b drawn(image.size(), static_cast<std::uint8_t>(1 - value));
      for (const PixelRun& run : findRuns(image, value)) {
        ASSERT_LT(run.begin, run.end);
        EXPECT_TRUE(run.begin == 0 || image(run.y, run.begin - 1) != value);
        EXPECT_TRUE(run.end == image.cols || image(run.y, run.end) != value);
        drawn.row(run.y).colRange(run.begin, run.end) = value;
      }
      EXPECT_EQ(cv::countNonZero(drawn != image), 0);
    }
  }
}

TEST(PixelRuns, HangTogetherLikeTheComponentsOfTheImage) {
  std::mt19937 random(2);
  for (unsigned trial = 0; trial < 200; ++trial) {
    const cv::Mat1b image = randomImage(random, 2 + trial % 3);
    const bool by_corners = trial % 2 == 0;
    cv::Mat1i expected;
    const int count = cv::connectedComponents(image, expected, by_corners ? 8 : 4, CV_32S);
    const auto runs = findRuns(image, 1);
    const auto component_of = connectRuns(runs, by_corners);
    std::map<std::uint32_t, int> known;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const bool is_new = component_of[i] == known.size();
      const int label = expected(runs[i].y, runs[i].begin);
      const auto found = known.emplace(component_of[i], label);
      EXPECT_EQ(found.second, is_new) << "numbered in the order of their first runs";
      EXPECT_EQ(found.first->second, label);
    }
    EXPECT_EQ(static_cast<int>(known.size()), count - 1);
  }
}

}  // namespace
}  // namespace agrid
