// SPDX-License-Identifier: BSD-3-Clause
#include "grid/edge_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace agrid {
namespace {

constexpr std::size_t kSampleSize = 20000;  // enough for a tenth of a degree on any map

/// Calls `visit` with the column and row of each edge pixel.
template <typename Visit>
void forEachEdge(const cv::Mat& edges, Visit visit) {
  for (int row = 0; row < edges.rows; ++row) {
    const std::uint8_t* pixels = edges.ptr<std::uint8_t>(row);
    for (int column = 0; column < edges.cols; ++column) {
      if (pixels[column] != 0) visit(column, row);
    }
  }
}

Point2 pixelCenter(const cv::Mat& edges, int column, int row) {
  return {column + 0.5, edges.rows - row - 0.5};
}

}  // namespace

double foldDirection(double direction_deg) {
  const double folded_deg = direction_deg - 90 * std::ceil(direction_deg / 90 - 0.5);
  return folded_deg * CV_PI / 180;
}

EdgeFrame edgeFrame(const MapGeometry& geometry, double direction) {
  const double width = geometry.width;
  const double height = geometry.height;
  if (direction == 0) return {Pose2{}, {width, height}, geometry.resolution};
  const Pose2 grid_from_image{Point2::Zero(), -direction};
  Point2 lowest = Point2::Zero();
  Point2 highest = Point2::Zero();
  for (const Point2& corner : {Point2(width, 0), Point2(0, height), Point2(width, height)}) {
    const Point2 turned = grid_from_image * corner;
    lowest = lowest.cwiseMin(turned);
    highest = highest.cwiseMax(turned);
  }
  const Pose2 turn{Point2::Zero(), direction};
  return {{turn * lowest * geometry.resolution, direction}, highest - lowest, geometry.resolution};
}

double maxTurnedPixels(const MapGeometry& geometry) {
  const double in_proportion = 16 * static_cast<double>(geometry.pixelCount()) + 1e6;
  return std::min(in_proportion, static_cast<double>(std::numeric_limits<int>::max()));
}

std::vector<Point2> sampleEdges(const cv::Mat& edges) {
  const auto count = static_cast<std::size_t>(cv::countNonZero(edges));
  const std::size_t stride = std::max<std::size_t>(1, (count + kSampleSize - 1) / kSampleSize);
  std::vector<Point2> sample;
  sample.reserve(count / stride + 1);
  std::size_t index = 0;
  forEachEdge(edges, [&](int column, int row) {
    if (index++ % stride == 0) sample.push_back(pixelCenter(edges, column, row));
  });
  return sample;
}

cv::Mat turnEdges(const cv::Mat& edges, const EdgeFrame& frame) {
  if (frame.image_from_grid.yaw == 0) return edges;
  const Pose2 grid_from_image = inverse(frame.image_from_grid);
  cv::Mat turned = cv::Mat::zeros(static_cast<int>(std::ceil(frame.extent_px.y())),
                                  static_cast<int>(std::ceil(frame.extent_px.x())), CV_8UC1);
  forEachEdge(edges, [&](int column, int row) {
    const Point2 point =
        grid_from_image * (pixelCenter(edges, column, row) * frame.resolution) / frame.resolution;
    const int x = std::clamp(static_cast<int>(point.x()), 0, turned.cols - 1);
    const int y = std::clamp(static_cast<int>(frame.extent_px.y() - point.y()), 0, turned.rows - 1);
    turned.at<std::uint8_t>(y, x) = 255;
  });
  return turned;
}

}  // namespace agrid
