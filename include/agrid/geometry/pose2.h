// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "agrid/geometry/point2.h"

namespace agrid {

/// A position and a heading in the plane, or the rigid transform that takes coordinates of the
/// frame at this pose to coordinates of the frame it is given in. Right-handed, yaw
/// counter-clockwise from x (REP-103). A pose named `a_from_b` composes by matching neighbours:
/// a_from_b * b_from_c.
struct Pose2 {
  Point2 position = Point2::Zero();  ///< [m]
  double yaw = 0;                    ///< [rad], not normalised
};

/// The point given in the inner frame, in the outer frame.
inline Point2 operator*(const Pose2& a_from_b, const Point2& point_b) {
  const double c = std::cos(a_from_b.yaw);
  const double s = std::sin(a_from_b.yaw);
  return a_from_b.position +
         Point2(c * point_b.x() - s * point_b.y(), s * point_b.x() + c * point_b.y());
}

/// a_from_b * b_from_c = a_from_c.
inline Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  return {a_from_b * b_from_c.position, a_from_b.yaw + b_from_c.yaw};
}

/// inverse(a_from_b) = b_from_a.
inline Pose2 inverse(const Pose2& a_from_b) {
  return {Pose2{Point2::Zero(), -a_from_b.yaw} * Point2(-a_from_b.position), -a_from_b.yaw};
}

}  // namespace agrid
