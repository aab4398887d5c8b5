// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/label_image.h"

#include <algorithm>

namespace agrid {

cv::Mat labelImage(const std::vector<std::uint16_t>& labels, const MapGeometry& geometry) {
  cv::Mat image(geometry.height, geometry.width, CV_16UC1);
  for (int y = 0; y < image.rows; ++y) {
    const std::uint16_t* row = labels.data() + geometry.index({0, image.rows - 1 - y});
    std::copy(row, row + image.cols, image.ptr<std::uint16_t>(y));
  }
  return image;
}

}  // namespace agrid
