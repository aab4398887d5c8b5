// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/main_direction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace agrid {
namespace {

constexpr double kRadPerDeg = 0.017453292519943295;
constexpr double kCoarseStepDeg = 0.5;
constexpr int kCoarseSteps = 90;  // up to 45 degrees
constexpr double kCoarseBin = 4;
constexpr double kFineStepDeg = 0.05;
constexpr double kFineBin = 1;
constexpr int kFineSteps = 12;  // on either side of the best coarse direction

/// Measures how sharp the two profiles of a set of points are.
class ProfileSharpness {
 public:
  explicit ProfileSharpness(const std::vector<Point2>& points) : points_(points) {
    for (const Point2& p : points_) center_ += p / static_cast<double>(points_.size());
    for (const Point2& p : points_) radius_ = std::max(radius_, (p - center_).norm());
  }

  double at(double direction_deg, double bin) const {
    const double c = std::cos(direction_deg * kRadPerDeg);
    const double s = std::sin(direction_deg * kRadPerDeg);
    return along({c, s}, bin) + along({-s, c}, bin);
  }

 private:
  double along(const Point2& axis, double bin) const {
    std::vector<double> profile(static_cast<std::size_t>(2 * radius_ / bin) + 4, 0);
    for (const Point2& p : points_) {
      // Sharing a point between two bins keeps the pixel raster from beating with the bins.
      const double place = (axis.dot(p - center_) + radius_) / bin + 1;
      const auto i = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(i);
      profile[i] += 1 - share;
      profile[i + 1] += share;
    }
    double sharpness = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
      const double rise = profile[i] - profile[i - 1];
      sharpness += rise * rise;
    }
    return sharpness;
  }

  const std::vector<Point2>& points_;
  Point2 center_ = Point2::Zero();
  double radius_ = 0;
};

double refine(const ProfileSharpness& sharpness, double coarse_deg) {
  double best_deg = coarse_deg;
  double best = 0;
  for (int i = -kFineSteps; i <= kFineSteps; ++i) {
    const double direction_deg = coarse_deg + i * kFineStepDeg;
    const double value = sharpness.at(direction_deg, kFineBin);
    if (value > best) {
      best = value;
      best_deg = direction_deg;
    }
  }
  return best_deg;
}

}  // namespace

double mainDirection(const std::vector<Point2>& points, const DirectionParams& params) {
  if (points.size() < 2) return 0;
  const ProfileSharpness sharpness(points);
  const double at_zero = sharpness.at(0, kCoarseBin);
  std::vector<double> values;
  double best = 0;
  double best_deg = 0;
  values.reserve(2 * kCoarseSteps);
  for (int i = 1 - kCoarseSteps; i <= kCoarseSteps; ++i) {
    const double deg = i * kCoarseStepDeg;
    values.push_back(sharpness.at(deg, kCoarseBin));
    if (values.back() > best) {
      best = values.back();
      best_deg = deg;
    }
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (best < params.min_gain * at_zero || best < params.min_contrast * *middle) return 0;
  double direction_deg = refine(sharpness, best_deg);
  if (direction_deg > 45) direction_deg -= 90;
  if (direction_deg <= -45) direction_deg += 90;
  return std::abs(direction_deg) < params.snap_deg ? 0 : direction_deg * kRadPerDeg;
}

}  // namespace agrid
