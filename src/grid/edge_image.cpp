// SPDX-License-Identifier: BSD-3-Clause
#include "grid/edge_image.h"

#include <opencv2/imgproc.hpp>

namespace agrid {
namespace {

std::uint8_t shade(Occupancy pixel) {
  switch (pixel) {
    case Occupancy::kFree:
      return 254;
    case Occupancy::kOccupied:
      return 0;
    case Occupancy::kUnknown:
      break;
  }
  return 205;
}

}  // namespace

cv::Mat drawForEdges(const OccupancyMap& map) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat image(geometry.height, geometry.width, CV_8UC1);
  for (int y = 0; y < geometry.height; ++y) {
    std::uint8_t* row = image.ptr<std::uint8_t>(geometry.height - 1 - y);
    for (int x = 0; x < geometry.width; ++x) row[x] = shade(map.at({x, y}));
  }
  return image;
}

cv::Mat detectEdges(const OccupancyMap& map, const WallParams& params) {
  cv::Mat edges;
  cv::Canny(drawForEdges(map), edges, params.canny_low, params.canny_high);
  return edges;
}

}  // namespace agrid
