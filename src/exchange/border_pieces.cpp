// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/border_pieces.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "areas/room_borders.h"

namespace agrid {
namespace {

constexpr double kMinBorder = 0.05;  // rooms leak through slits [m]
constexpr double kReach = 0.5;       // between a border and what is beside it [m]
constexpr double kStraight = 0.25;   // what a piece may leave its line by [m]
constexpr double kOverlap = 1.5;     // of pieces that follow each other [px]

using Points = std::vector<BorderPoint>;

/// Distance of each pixel from the nearest labelled one [px].
cv::Mat1f distanceFromLabels(const std::vector<std::uint16_t>& labels,
                             const MapGeometry& geometry) {
  cv::Mat1b unlabelled(geometry.height, geometry.width);
  std::transform(labels.begin(), labels.end(), unlabelled.begin(),
                 [](std::uint16_t label) { return static_cast<std::uint8_t>(label == 0); });
  cv::Mat1f distance;
  cv::distanceTransform(unlabelled, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance;
}

/// The point farthest from another one.
Point2 farthest(const Points& points, const Point2& from, const MapGeometry& geometry) {
  Point2 best = from;
  for (const BorderPoint& point : points) {
    const Point2 p = point.position(geometry);
    if ((p - from).squaredNorm() > (best - from).squaredNorm()) best = p;
  }
  return best;
}

/// Cuts points of a border into runs that lie near a straight line (Douglas and Peucker).
void splitStraight(const Points& points, const MapGeometry& geometry, std::vector<Points>& runs) {
  const Point2 a = farthest(points, points.front().position(geometry), geometry);
  const Point2 along = farthest(points, a, geometry) - a;
  const double length = along.norm();
  double bend = kStraight / geometry.resolution;
  double cut = -1;
  for (const BorderPoint& point : points) {
    if (length == 0) break;
    const Point2 p = point.position(geometry) - a;
    const double off = std::abs(along.x() * p.y() - along.y() * p.x()) / length;
    if (off <= bend) continue;
    bend = off;
    cut = p.dot(along) / length;
  }
  Points before;
  Points after;
  for (const BorderPoint& point : points) {
    const double place = length == 0 ? 0 : (point.position(geometry) - a).dot(along) / length;
    (place <= cut ? before : after).push_back(point);
  }
  if (before.empty() || after.empty()) {
    runs.push_back(points);
    return;
  }
  splitStraight(before, geometry, runs);
  splitStraight(after, geometry, runs);
}

class PieceFinder {
 public:
  PieceFinder(const OccupancyMap& map, const std::vector<std::uint16_t>& labels)
      : map_(map), labels_(labels) {}

  BorderPiece pieceOf(const Points& points) const {
    const MapGeometry& geometry = map_.geometry();
    Point2 a = farthest(points, points.front().position(geometry), geometry);
    Point2 b = farthest(points, a, geometry);
    if (const double length = (b - a).norm(); length > 0) {
      const Point2 more = (b - a) * (kOverlap / length);
      a -= more;
      b += more;
    }
    const auto inMap = [&](const Point2& p) -> Point2 {
      return geometry.map_from_image * Point2(p * geometry.resolution);
    };
    BorderPiece piece{{inMap(a), inMap(b)}, {}};
    for (const BorderPoint& point : points) {
      const Pixel p = geometry.pixel(point.pixel);
      const Pixel q = geometry.pixel(point.other);
      const Pixel step{q.x - p.x, q.y - p.y};
      piece.beside.push_back({walk(p, {-step.x, -step.y}), walk(q, step)});
    }
    return piece;
  }

 private:
  /// The last pixel of the first area that lies that way.
  std::size_t walk(Pixel p, Pixel step) const {
    const MapGeometry& geometry = map_.geometry();
    std::size_t last = geometry.index(p);
    std::uint16_t label = labels_[last];
    const int most = static_cast<int>(kReach / geometry.resolution);
    for (int i = 0; i < most; ++i) {
      p = {p.x + step.x, p.y + step.y};
      if (!geometry.contains(p) || !map_.isFree(p)) break;
      const std::uint16_t here = labels_[geometry.index(p)];
      if (label != 0 && here != label) break;
      label = here;
      last = geometry.index(p);
    }
    return last;
  }

  const OccupancyMap& map_;
  const std::vector<std::uint16_t>& labels_;
};

}  // namespace

std::vector<BorderPiece> findBorderPieces(const OccupancyMap& map,
                                          const std::vector<std::uint16_t>& labels) {
  const MapGeometry& geometry = map.geometry();
  const cv::Mat1f distance = distanceFromLabels(labels, geometry);
  const PieceFinder finder(map, labels);
  std::vector<BorderPiece> pieces;
  for (const Stretch& stretch : findRoomBorders(map, labels, kMinBorder)) {
    Points near;
    for (const BorderPoint& point : stretch) {
      const Pixel p = geometry.pixel(point.pixel);
      if (distance(p.y, p.x) <= kReach / geometry.resolution) near.push_back(point);
    }
    if (near.empty() || 2 * near.size() < stretch.size()) continue;
    std::vector<Points> runs;
    splitStraight(near, geometry, runs);
    for (const Points& run : runs) pieces.push_back(finder.pieceOf(run));
  }
  return pieces;
}

}  // namespace agrid
