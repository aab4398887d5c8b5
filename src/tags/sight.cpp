// SPDX-License-Identifier: BSD-3-Clause
#include "tags/sight.h"

#include <algorithm>
#include <cmath>

namespace agrid {
namespace {

constexpr double kStep = 0.5;     // [px]
constexpr double kBeside = 0.05;  // [m]
constexpr double kStray = 0.02;   // sideways per length of line
constexpr double kAside = 0.3;    // how far from a line's end its wall is looked at [m]

Point2 normalOf(const Point2& direction) { return {-direction.y(), direction.x()}; }

}  // namespace

Sight::Sight(const cv::Mat1b& free_space, const cv::Mat1f& height, double resolution)
    : free_space_(free_space),
      height_(height),
      resolution_(resolution),
      beside_(std::max(1., pixels(kBeside))) {}

bool Sight::isWall(const Point2& point) const {
  const auto x = static_cast<int>(std::floor(point.x()));
  const auto y = static_cast<int>(std::floor(point.y()));
  return x < 0 || y < 0 || x >= free_space_.cols || y >= free_space_.rows || free_space_(y, x) == 0;
}

double Sight::safeStep(const Point2& point) const {
  const auto x = static_cast<int>(std::floor(point.x()));
  const auto y = static_cast<int>(std::floor(point.y()));
  if (x < 0 || y < 0 || x >= height_.cols || y >= height_.rows || free_space_(y, x) == 0) return 0;
  // between centres; point and wall may each lie half a diagonal nearer
  constexpr double kDiagonal = 1.42;
  const double steps = (static_cast<double>(height_(y, x)) - kDiagonal) / kStep;
  return std::max(kStep, std::floor(steps) * kStep);
}

double Sight::freeRun(const Point2& start, const Point2& direction, double reach) const {
  double run = 0;
  while (run < reach) {
    const double step = safeStep(start + direction * run);
    if (step == 0) break;
    run += step;
  }
  return std::min(run, reach);
}

bool Sight::isWallBeside(const Point2& start, const Point2& direction, double at) const {
  const Point2 point = start + direction * at;
  if (isWall(point)) return true;
  const Point2 normal = normalOf(direction);
  const double farthest = beside_ + kStray * at;
  for (double aside = 1; aside <= farthest; aside += 1) {
    if (isWall(point + normal * aside) || isWall(point - normal * aside)) return true;
  }
  return false;
}

double Sight::wallRun(const Point2& start, const Point2& direction, double reach) const {
  double run = 0;
  while (run < reach && isWallBeside(start, direction, run)) run += kStep;
  return std::min(run, reach);
}

double Sight::wallShare(const Point2& start, const Point2& direction, double length) const {
  int walls = 0;
  int points = 0;
  for (double at = 0; at < length; at += 1, ++points) {
    if (isWallBeside(start, direction, at)) ++walls;
  }
  return points == 0 ? 0 : static_cast<double>(walls) / points;
}

Sight::End Sight::endOf(const Point2& start, const Point2& direction, double length) const {
  const double aside = std::max(2., pixels(kAside));
  const Point2 shift = normalOf(direction) * aside;
  const double left = freeRun(start + shift, direction, length + 3 * aside);
  const double right = freeRun(start - shift, direction, length + 3 * aside);
  End end;
  end.is_flat = std::max(left, right) < length + 2.9 * aside &&
                std::min(left, right) > std::max(1., length - 3 * aside);
  if (end.is_flat) end.slope = std::abs(left - right) / (2 * aside);
  return end;
}

}  // namespace agrid
