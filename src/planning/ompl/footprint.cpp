// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace agrid::planning {
namespace {

constexpr std::size_t kMaxCorners = 1000;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

double pointDistance(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

/// Whether the segments cross at a point inside both.
bool cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  return ((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0));
}

/// Sides that follow each other share a corner, and may meet nowhere else.
bool foldsBack(const Point2& a, const Point2& corner, const Point2& b) {
  return cross(a - corner, b - corner) == 0 && (a - corner).dot(b - corner) >= 0;
}

bool crossesItself(const Polygon& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % n];
    if (foldsBack(a, b, corners[(i + 2) % n])) return true;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segmentDistance(a, b, corners[j], corners[(j + 1) % n]) == 0) return true;
    }
  }
  return false;
}

}  // namespace

Footprint::Footprint(const Polygon& corners) : corners_(corners) {
  inner_radius_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& next = corners[(i + 1) % corners.size()];
    inner_radius_ = std::min(inner_radius_, pointDistance(Point2::Zero(), corners[i], next));
    outer_radius_ = std::max(outer_radius_, corners[i].norm());
  }
}

std::string footprintProblem(const Polygon& corners) {
  if (corners.size() < 3 || corners.size() > kMaxCorners) {
    return "footprint has " + std::to_string(corners.size()) + " points: must be 3 to " +
           std::to_string(kMaxCorners);
  }
  for (const Point2& p : corners) {
    if (!p.allFinite()) return "footprint has a point that is not finite";
  }
  if (crossesItself(corners)) return "footprint has sides that meet elsewhere than at a corner";
  if (!isInside(corners, Point2::Zero())) return "footprint must have the robot's origin inside";
  return {};
}

bool isInside(const Polygon& polygon, const Point2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

double segmentDistance(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (cross(a, b, c, d)) return 0;
  return std::min({pointDistance(a, c, d), pointDistance(b, c, d), pointDistance(c, a, b),
                   pointDistance(d, a, b)});
}

bool isNearSquare(const Polygon& polygon, const Point2& center, double reach) {
  if (isInside(polygon, center)) return true;
  const std::array<Point2, 4> square{center + Point2(-0.5, -0.5), center + Point2(0.5, -0.5),
                                     center + Point2(0.5, 0.5), center + Point2(-0.5, 0.5)};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    if (((a - center).cwiseAbs().maxCoeff()) <= 0.5) return true;
    for (std::size_t k = 0; k < 4; ++k) {
      if (segmentDistance(a, b, square[k], square[(k + 1) % 4]) <= reach) return true;
    }
  }
  return false;
}

}  // namespace agrid::planning
