// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/label_image.h"

#include <gtest/gtest.h>

namespace agrid {
namespace {

TEST(LabelImage, LabelsAreFlippedOnce) {
  const MapGeometry geometry{2, 3, 1, {}};
  const cv::Mat image = labelImage({1, 2, 3, 4, 5, 60000}, geometry);
  ASSERT_EQ(image.type(), CV_16UC1);
  EXPECT_EQ(image.at<std::uint16_t>(0, 1), 60000);
  EXPECT_EQ(image.at<std::uint16_t>(2, 0), 1);
  EXPECT_EQ(image.at<std::uint16_t>(2, 1), 2);
}

}  // namespace
}  // namespace agrid
