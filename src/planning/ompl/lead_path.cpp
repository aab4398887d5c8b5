// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/lead_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace agrid::planning {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Share of poses that head the other way: a robot may have to back up.
constexpr double kReversed = 0.1;

}  // namespace

LeadPath::LeadPath(std::vector<Point2> corners) : corners_(std::move(corners)) {
  lengths_.push_back(0);
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    lengths_.push_back(lengths_.back() + (corners_[i] - corners_[i - 1]).norm());
  }
}

Point2 LeadPath::at(double along) const {
  const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), along);
  if (above == lengths_.begin()) return corners_.front();
  if (above == lengths_.end()) return corners_.back();
  const auto i = static_cast<std::size_t>(above - lengths_.begin());
  const double t = (along - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
  return corners_[i - 1] + t * (corners_[i] - corners_[i - 1]);
}

double LeadPath::nearest(const Point2& point) const {
  double best = (point - corners_.front()).squaredNorm();
  double along = 0;
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    const Point2 side = corners_[i] - corners_[i - 1];
    const double square = side.squaredNorm();
    if (square == 0) continue;
    const double t = std::clamp((point - corners_[i - 1]).dot(side) / square, 0.0, 1.0);
    const double distance = (corners_[i - 1] + t * side - point).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    along = lengths_[i - 1] + t * std::sqrt(square);
  }
  return along;
}

double LeadPath::heading(double along, double before, double behind) const {
  const Point2 chord = at(along + behind) - at(along - before);
  return std::atan2(chord.y(), chord.x());
}

Pose2 LeadSamples::near(double along) {
  const double before = random_.uniformReal(0, 2 * scale_);
  const double behind = random_.uniformReal(0.01, 2) * scale_;
  const double spread = scale_ * std::exp2(-7 * random_.uniform01());
  const double turned = std::exp2(-6 * random_.uniform01());
  Pose2 pose;
  pose.position = lead_.at(along);
  pose.position += Point2(random_.gaussian(0, spread), random_.gaussian(0, spread));
  pose.yaw = lead_.heading(along, before, behind) + random_.gaussian(0, turned);
  if (random_.uniform01() < kReversed) pose.yaw += kPi;
  return pose;
}

}  // namespace agrid::planning
