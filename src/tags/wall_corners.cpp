// SPDX-License-Identifier: BSD-3-Clause
#include "tags/wall_corners.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace agrid {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kStraightening = 0.12;  // [m]
constexpr double kLongWall = 1;          // [m]
constexpr double kShortWall = 0.5;       // [m]
constexpr double kMaxTolerance = 0.44;   // 25 degrees [rad]
constexpr int kNear = 4;                 // bins on either side that are one direction

double straighteningOf(double resolution) {  // [px]
  return std::max(1.3, kStraightening / resolution);
}

double angleOfLine(const Point2& direction) {
  const double angle = std::atan2(direction.y(), direction.x());
  if (angle < 0) return angle + kPi;
  return angle >= kPi ? angle - kPi : angle;
}

}  // namespace

std::vector<WallCorner> findWallCorners(const cv::Mat1b& free_space, double resolution) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(free_space, outlines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  const double straightening_px = straighteningOf(resolution);
  std::vector<WallCorner> corners;
  std::vector<cv::Point> polygon;
  for (const auto& outline : outlines) {
    cv::approxPolyDP(outline, polygon, straightening_px, true);
    const std::size_t count = polygon.size();
    if (count < 2) continue;
    const auto at = [&](std::size_t i) {
      return Point2(polygon[i % count].x + 0.5, polygon[i % count].y + 0.5);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 point = at(i);
      corners.push_back({point, {at(i + count - 1) - point, at(i + 1) - point}});
    }
  }
  return corners;
}

WallDirections::WallDirections(const std::vector<WallCorner>& corners, double resolution)
    : resolution_(resolution) {
  for (const WallCorner& corner : corners) {
    const Point2& wall = corner.arms[1];  // each wall is the second arm of one corner
    if (wall.norm() * resolution < kLongWall) continue;
    const double angle = angleOfLine(wall);
    const auto bin = static_cast<std::size_t>(angle / kPi * kBins) % kBins;
    weight_[bin] += wall.squaredNorm();
    weighted_angle_[bin] += wall.squaredNorm() * angle;
  }
  for (int bin = 0; bin < kBins; ++bin) {
    for (int near = bin - kNear; near <= bin + kNear; ++near) {
      weight_around_[static_cast<std::size_t>(bin)] += weight_[binOf(near)];
    }
  }
}

std::optional<Point2> WallDirections::align(const Point2& wall) const {
  const double length = wall.norm();
  const double tolerance = std::min(
      kMaxTolerance, std::atan2(straighteningOf(resolution_) * resolution_, length * resolution_));
  const double angle = angleOfLine(wall);
  const int middle = static_cast<int>(angle / kPi * kBins);
  const int reach = static_cast<int>(std::ceil(tolerance / kPi * kBins));
  int best = middle;
  for (int bin = middle - reach; bin <= middle + reach; ++bin) {
    if (weightAround(bin) > weightAround(best)) best = bin;
  }
  double weight = 0;
  double weighted_turn = 0;
  for (int near = best - kNear; near <= best + kNear; ++near) {
    const auto bin = binOf(near);
    if (weight_[bin] == 0) continue;
    weight += weight_[bin];
    weighted_turn +=
        weight_[bin] * std::remainder(weighted_angle_[bin] / weight_[bin] - angle, kPi);
  }
  const Point2 direction = wall / length;
  if (weight == 0)
    return length * resolution_ < kShortWall ? std::nullopt : std::optional(direction);
  const double turn = weighted_turn / weight;
  return Point2{direction.x() * std::cos(turn) - direction.y() * std::sin(turn),
                direction.x() * std::sin(turn) + direction.y() * std::cos(turn)};
}

}  // namespace agrid
