// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/swept_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agrid::planning {
namespace {

/// A part of a motion that is this short and not proved free is taken as not free [px].
constexpr double kShortest = 1.0 / 128;

Polygon scaled(const Polygon& polygon, double factor) {
  Polygon result = polygon;
  for (Point2& p : result) p *= factor;
  return result;
}

int firstTouched(double low) { return static_cast<int>(std::ceil(low - 0.5)); }
int lastTouched(double high) { return static_cast<int>(std::floor(high + 0.5)); }

}  // namespace

/// From `begin` to `end` of a piece, as shares of it.
struct SweptRobot::Part {
  double begin = 0;
  double end = 1;
};

SweptRobot::SweptRobot(FreeSpace free, const Obstacles& obstacles, const Polygon& footprint_map)
    : free_(std::move(free)),
      obstacles_(&obstacles),
      outline_px_(Footprint(scaled(footprint_map, 1 / free_.geometry().resolution))) {}

Pose2 SweptRobot::toImage(const Pose2& pose_map) const {
  return {pixelCoordinates(free_.geometry(), pose_map.position),
          pose_map.yaw - free_.geometry().map_from_image.yaw};
}

bool SweptRobot::isFree(const Pose2& pose_map) const {
  const Pose2 pose = toImage(pose_map);
  // Also false for NaN. Far outside, pixels could not be counted.
  const double extent = free_.geometry().width + free_.geometry().height;
  if (!(pose.position.cwiseAbs().maxCoeff() <= extent)) return false;
  const Point2 margin = Point2::Constant(outline_px_ ? 0 : kMargin);
  return areTouchedFree(pose.position - margin, pose.position + margin) &&
         (!outline_px_ || isFarFromObstacles(pose, 0) || isOutlineFree(pose, 0));
}

bool SweptRobot::isFree(const MotionPiece& piece_map) const {
  MotionPiece piece = piece_map;
  piece.from = toImage(piece_map.from);
  if (!isFree(piece_map.from) || !std::isfinite(piece.length)) return false;
  piece.length /= free_.geometry().resolution;
  piece.direction -= free_.geometry().map_from_image.yaw;
  if (!outline_px_ && piece.length == 0) return true;
  // The box of a part holds it, as long as it turns by no more than a right angle.
  const int parts = 1 + static_cast<int>(std::abs(piece.turn) / 1.5);
  for (int i = 0; i < parts; ++i) {
    const double share = 1.0 / parts;
    if (!isPartFree(piece, {i * share, (i + 1) * share})) return false;
  }
  return true;
}

bool SweptRobot::isPartFree(const MotionPiece& piece, const Part& part) const {
  const double middle = (part.begin + part.end) / 2;
  const double share = (part.end - part.begin) / 2;
  const Pose2 pose = piece.at(middle);
  const double way = std::abs(piece.length) * share;
  const double turned = outline_px_ ? outline_px_->outerRadius() * std::abs(piece.turn) * share : 0;
  if (isFarFromObstacles(pose, way + turned)) return true;
  if (!areTouchedFree(pose.position, pose.position)) return false;
  if (outline_px_ && !isOutlineFree(pose, 0)) return false;

  const Point2 a = piece.at(part.begin).position;
  const Point2 b = piece.at(part.end).position;
  const double bulge = way * way * piece.curvature() / 2 + kMargin;
  const bool is_box_free = areTouchedFree(a.cwiseMin(b) - Point2::Constant(bulge),
                                          a.cwiseMax(b) + Point2::Constant(bulge));
  if (is_box_free && (!outline_px_ || isOutlineFree(pose, way + turned + kMargin))) return true;
  if (way + turned < kShortest) return false;
  return isPartFree(piece, {part.begin, middle}) && isPartFree(piece, {middle, part.end});
}

bool SweptRobot::isFarFromObstacles(const Pose2& pose, double reach) const {
  const MapGeometry& g = free_.geometry();
  const Point2& p = pose.position;
  const double outline = outline_px_ ? outline_px_->outerRadius() : 0;
  // Beyond the map, which the distances know nothing of, nothing is free.
  const double ring = outline + reach + kMargin + 0.5;
  if (p.x() - ring <= 0 || p.y() - ring <= 0 || p.x() + ring >= g.width - 1 ||
      p.y() + ring >= g.height - 1) {
    return false;
  }
  const Pixel pixel{static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
  if (free_.keepOut() && free_.keepOut()->mayBeNear(p, ring)) return false;
  const double needed = std::max(free_.radiusPx(), outline) + reach + kMargin;
  return std::sqrt(free_.squaredDistance(pixel)) > needed + kTwoHalfDiagonals;
}

bool SweptRobot::areTouchedFree(const Point2& low, const Point2& high) const {
  for (int y = firstTouched(low.y()); y <= lastTouched(high.y()); ++y) {
    for (int x = firstTouched(low.x()); x <= lastTouched(high.x()); ++x) {
      if (!free_.isFree({x, y})) return false;
    }
  }
  return true;
}

bool SweptRobot::isOutlineFree(const Pose2& pose, double reach) const {
  Polygon outline;
  Point2 low = pose.position;
  Point2 high = pose.position;
  for (const Point2& corner : outline_px_->corners()) {
    outline.push_back(pose * corner);
    low = low.cwiseMin(outline.back());
    high = high.cwiseMax(outline.back());
  }
  for (int y = firstTouched(low.y() - reach); y <= lastTouched(high.y() + reach); ++y) {
    for (int x = firstTouched(low.x() - reach); x <= lastTouched(high.x() + reach);) {
      if (isObstacle({x, y}) && isNearSquare(outline, Point2(x, y), reach)) return false;
      x += freeColumnsFrom({x, y});
    }
  }
  return true;
}

int SweptRobot::freeColumnsFrom(Pixel p) const {
  const MapGeometry& g = free_.geometry();
  if (!g.contains(p)) return 1;
  const double distance = std::ceil(std::sqrt(free_.squaredDistance(p)));
  return std::clamp(static_cast<int>(std::min(distance, 1e9)), 1, g.width - p.x);
}

bool SweptRobot::isObstacle(Pixel p) const {
  const MapGeometry& g = free_.geometry();
  return !g.contains(p) || (free_.squaredDistance(p) == 0 && obstacles_->at(g.index(p)));
}

double SweptRobot::outerRadius() const {
  const double px = outline_px_ ? outline_px_->outerRadius() : free_.radiusPx();
  return px * free_.geometry().resolution;
}

double SweptRobot::clearance(const Pose2& pose_map) const {
  const Pose2 pose = toImage(pose_map);
  const Pixel pixel = finePoint(pose.position).pixel();
  const MapGeometry& g = free_.geometry();
  if (!g.contains(pixel)) return -g.resolution;
  const double distance = std::sqrt(free_.squaredDistance(pixel)) * g.resolution;
  return distance - free_.radiusPx() * g.resolution;
}

}  // namespace agrid::planning
