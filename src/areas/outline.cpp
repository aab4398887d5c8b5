// SPDX-License-Identifier: BSD-3-Clause
#include "areas/outline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace agrid {
namespace {

constexpr double kTolerancePx = 1;

cv::Mat1b largestPart(const cv::Mat1b& shape) {
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(shape, labels, stats, centroids, 4, CV_32S);
  int largest = 1;
  for (int i = 2; i < count; ++i) {
    if (stats(i, cv::CC_STAT_AREA) > stats(largest, cv::CC_STAT_AREA)) largest = i;
  }
  cv::Mat1b part;
  cv::compare(labels, largest, part, cv::CMP_EQ);
  return part;
}

/// Walks around a 4-connected shape with the shape on the left, from corner to corner.
std::vector<cv::Point> traceCorners(const cv::Mat1b& shape, const cv::Point& lowest) {
  static const std::array<cv::Point, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // pixel ahead on the left of a vertex, for each heading; the one on the right is the next
  // heading's
  static const std::array<cv::Point, 4> kLeft{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  const cv::Rect bounds(0, 0, shape.cols, shape.rows);
  const auto inside = [&](const cv::Point& p) { return bounds.contains(p) && shape(p) != 0; };
  std::vector<cv::Point> corners;
  cv::Point vertex = lowest;
  std::size_t heading = 0;
  do {
    vertex += kSteps[heading];
    std::size_t turned = heading;
    if (!inside(vertex + kLeft[heading])) {
      turned = (heading + 1) % 4;
    } else if (inside(vertex + kLeft[(heading + 3) % 4])) {
      turned = (heading + 3) % 4;
    }
    if (turned != heading) corners.push_back(vertex);
    heading = turned;
  } while (vertex != lowest || heading != 0);
  return corners;
}

}  // namespace

Polygon traceOutline(const cv::Mat1b& shape) {
  const cv::Mat1b part = largestPart(shape);
  const auto lowest = std::find_if(part.begin(), part.end(), [](std::uint8_t v) { return v != 0; });
  if (lowest == part.end()) return {};
  std::vector<cv::Point> corners = traceCorners(part, lowest.pos());
  std::vector<cv::Point> simplified;
  cv::approxPolyDP(corners, simplified, kTolerancePx, true);
  // a shape as thin as the tolerance would collapse
  if (cv::contourArea(simplified) > 0.9 * cv::contourArea(corners)) corners = simplified;
  Polygon outline;
  for (const cv::Point& corner : corners) outline.emplace_back(corner.x, corner.y);
  return outline;
}

}  // namespace agrid
