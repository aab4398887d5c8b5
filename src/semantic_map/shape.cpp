// SPDX-License-Identifier: BSD-3-Clause
#include "semantic_map/shape.h"

#include <algorithm>
#include <utility>

namespace agrid {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

std::size_t edgeCount(const Shape& shape) {
  return shape.corners.size() > 2 ? shape.corners.size() : 1;
}

/// The sides of a polygon; of a line, itself; of a point, one of no length.
Segment edgeOf(const Shape& shape, std::size_t i) {
  return {shape.corners[i], shape.corners[(i + 1) % shape.corners.size()]};
}

Point2 nearestOn(const Segment& segment, const Point2& point) {
  const Point2 along = segment.b - segment.a;
  const double squared = along.squaredNorm();
  if (squared == 0) return segment.a;
  return segment.a + along * std::clamp((point - segment.a).dot(along) / squared, 0., 1.);
}

double distanceTo(const Segment& segment, const Point2& point) {
  return (nearestOn(segment, point) - point).norm();
}

bool cross(const Segment& a, const Segment& b) {
  const Point2 along_a = a.b - a.a;
  const Point2 along_b = b.b - b.a;
  return cross(along_a, b.a - a.a) * cross(along_a, b.b - a.a) < 0 &&
         cross(along_b, a.a - b.a) * cross(along_b, a.b - b.a) < 0;
}

double distanceBetween(const Segment& a, const Segment& b) {
  if (cross(a, b)) return 0;
  return std::min({distanceTo(a, b.a), distanceTo(a, b.b), distanceTo(b, a.a), distanceTo(b, a.b)});
}

/// Distance between two boxes: no more than that of what they hold.
double boxDistance(const Point2& low_a, const Point2& high_a, const Point2& low_b,
                   const Point2& high_b) {
  const Point2 gap = (low_a - high_b).cwiseMax(low_b - high_a).cwiseMax(Point2::Zero());
  return gap.norm();
}

double boxDistance(const Segment& edge, const Point2& low, const Point2& high) {
  return boxDistance(edge.a.cwiseMin(edge.b), edge.a.cwiseMax(edge.b), low, high);
}

/// The least distance of an edge from a shape's outline if it is less than `best`, else that.
double outlineDistance(const Segment& edge, const Shape& shape, double best) {
  const Point2 low = edge.a.cwiseMin(edge.b);
  const Point2 high = edge.a.cwiseMax(edge.b);
  for (std::size_t i = 0; i < edgeCount(shape); ++i) {
    const Segment other = edgeOf(shape, i);
    if (boxDistance(other, low, high) < best) best = std::min(best, distanceBetween(edge, other));
  }
  return best;
}

struct ShapeOf {
  std::vector<Point2> operator()(const Area* area) const {
    if (area->outline_map.empty()) return {area->anchor_map};
    return area->outline_map;
  }
  std::vector<Point2> operator()(const Door* door) const {
    return {door->jambs_map.a, door->jambs_map.b};
  }
  std::vector<Point2> operator()(const ObjectTag* object) const {
    const Point2 half = object->size / 2;
    if (half.isZero()) return {object->pose_map.position};
    std::vector<Point2> corners;
    for (const Point2& corner : {Point2(-half.x(), -half.y()), Point2(half.x(), -half.y()), half,
                                 Point2(-half.x(), half.y())}) {
      corners.push_back(object->pose_map * corner);
    }
    return corners;
  }
};

}  // namespace

Shape::Shape(std::vector<Point2> corners_map) : corners(std::move(corners_map)) {
  low = high = corners.at(0);
  for (const Point2& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
}

Shape shapeOf(const Thing& thing) { return Shape(std::visit(ShapeOf{}, thing)); }

bool contains(const Shape& shape, const Point2& point) {
  if (shape.corners.size() < 3 || (point.array() < shape.low.array()).any() ||
      (point.array() > shape.high.array()).any()) {
    return false;
  }
  bool inside = false;  // crossings of the ray to the right
  for (std::size_t i = 0; i < edgeCount(shape); ++i) {
    const Segment edge = edgeOf(shape, i);
    if ((edge.a.y() > point.y()) == (edge.b.y() > point.y())) continue;
    const double share = (point.y() - edge.a.y()) / (edge.b.y() - edge.a.y());
    if (point.x() < edge.a.x() + share * (edge.b.x() - edge.a.x())) inside = !inside;
  }
  return inside;
}

Point2 nearestPoint(const Shape& shape, const Point2& point) {
  if (contains(shape, point)) return point;
  Point2 best = shape.corners[0];
  for (std::size_t i = 0; i < edgeCount(shape); ++i) {
    const Point2 candidate = nearestOn(edgeOf(shape, i), point);
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
  }
  return best;
}

double distanceBetween(const Shape& a, const Shape& b, double limit) {
  if (boxDistance(a.low, a.high, b.low, b.high) > limit) return kInfinity;
  if (contains(a, b.corners[0]) || contains(b, a.corners[0])) return 0;
  double best = kInfinity;
  for (std::size_t i = 0; i < edgeCount(a); ++i) {
    const Segment edge = edgeOf(a, i);
    if (boxDistance(edge, b.low, b.high) < best) best = outlineDistance(edge, b, best);
  }
  return best;
}

}  // namespace agrid
