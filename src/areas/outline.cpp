// SPDX-License-Identifier: BSD-3-Clause
#include "areas/outline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "tags/pixel_runs.h"

namespace agrid {
namespace {

constexpr double kTolerancePx = 1;

/// The first pixel of the largest 4-connected part of a shape.
cv::Point largestPart(const std::vector<PixelRun>& runs) {
  const std::vector<std::uint32_t> part_of = connectRuns(runs, false);
  struct Part {
    cv::Point first;
    std::int64_t size = 0;
  };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (part_of[i] == parts.size()) parts.push_back({{runs[i].begin, runs[i].y}, 0});
    parts[part_of[i]].size += runs[i].end - runs[i].begin;
  }
  return std::max_element(parts.begin(), parts.end(),
                          [](const Part& a, const Part& b) { return a.size < b.size; })
      ->first;
}

/// Walks around one 4-connected part of a shape with the part on the left, from corner to corner.
/// Other parts are never entered: they touch it by corners at most, where the walk turns left.
std::vector<cv::Point> traceCorners(const IsInside& inside, const cv::Point& lowest) {
  static const std::array<cv::Point, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // pixel ahead on the left of a vertex, for each heading; the one on the right is the next
  // heading's
  static const std::array<cv::Point, 4> kLeft{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
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
  const cv::Rect bounds(0, 0, shape.cols, shape.rows);
  return traceOutline(findRuns(shape, 1),
                      [&](const cv::Point& p) { return bounds.contains(p) && shape(p) != 0; });
}

Polygon traceOutline(const std::vector<PixelRun>& runs, const IsInside& inside) {
  if (runs.empty()) return {};
  const std::vector<cv::Point> corners = traceCorners(inside, largestPart(runs));
  std::vector<cv::Point> simplified;
  cv::approxPolyDP(corners, simplified, kTolerancePx, true);
  // a shape as thin as the tolerance would collapse
  if (cv::contourArea(simplified) <= 0.9 * cv::contourArea(corners)) simplified = corners;
  Polygon outline;
  for (const cv::Point& corner : simplified) outline.emplace_back(corner.x, corner.y);
  return outline;
}

}  // namespace agrid
