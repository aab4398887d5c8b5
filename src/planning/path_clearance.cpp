// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "map/squared_distance.h"
#include "planning/path_facts.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

/// Beyond it the window around a pixel would be large, and nobody asks for the last pixel.
constexpr double kExactPx = 64;

double pointToSegment(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

double pointToSquare(const Point2& p, Pixel square) {
  return std::hypot(std::max(std::abs(p.x() - square.x) - 0.5, 0.0),
                    std::max(std::abs(p.y() - square.y) - 0.5, 0.0));
}

/// Distance of a segment to a pixel's square. They never overlap: the segment's pixels are free.
double segmentToSquare(const Point2& a, const Point2& b, Pixel square) {
  double distance = std::min(pointToSquare(a, square), pointToSquare(b, square));
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      distance = std::min(distance, pointToSegment({square.x + x, square.y + y}, a, b));
    }
  }
  return distance;
}

/// Smallest squared distance of the pixels that a path touches, centre to centre [px^2].
std::int32_t leastSquaredDistance(const FreeSpace& free, const std::vector<FinePoint>& path) {
  std::int32_t least = kFarSquared;
  for (std::size_t i = 0; i < path.size(); ++i) {
    walkTouched(path[i == 0 ? 0 : i - 1], path[i], [&](Pixel p) {
      if (free.geometry().contains(p)) least = std::min(least, free.squaredDistance(p));
      return true;
    });
  }
  return least;
}

/// Looks for the obstacle nearest to a segment: in each column (see SegmentRaster), the first
/// obstacle above the segment and the first below it are the nearest ones of the column.
class NearestObstacle {
 public:
  NearestObstacle(const FreeSpace& free, const Obstacles& obstacles, double distance)
      : free_(free), obstacles_(obstacles), distance_(distance) {}

  double distance() const { return distance_; }

  void look(FinePoint a, FinePoint b) {
    const SegmentRaster raster(a, b);
    a_ = coordinates(a);
    b_ = coordinates(b);
    const Point2 along = b_ - a_;
    length_ = along.norm();
    normal_ = length_ > 0 ? Point2(Point2(-along.y(), along.x()) / length_) : Point2(0, 0);
    const int low = std::min(raster.first(), raster.last());
    const int high = std::max(raster.first(), raster.last());
    // A steep line is seen along its longer axis: a distance is at most sqrt(2) rows.
    const auto columns = static_cast<int>(distance_) + 1;
    for (int c = low - columns; c <= high + columns; ++c) {
      const SegmentRaster::Rows rows = raster.touched(std::clamp(c, low, high));
      const Pixel nearest = raster.pixel(c, rows.low);
      const double reach = distance_ * std::sqrt(2) + 2;
      if (!free_.geometry().contains(nearest) ||
          free_.squaredDistance(nearest) > (reach + 1) * (reach + 1)) {
        continue;
      }
      lookAlong(raster, c, rows.high, 1, reach);
      lookAlong(raster, c, rows.low, -1, reach);
    }
  }

 private:
  void lookAlong(const SegmentRaster& raster, int column, int row, int step, double reach) {
    for (int n = 0; n <= reach; ++n) {
      const Pixel p = raster.pixel(column, row + n * step);
      if (!free_.geometry().contains(p)) return;
      if (free_.squaredDistance(p) != 0 || !obstacles_.at(free_.geometry().index(p))) continue;
      // Of the line, which is nearer than the segment, to the square's nearest corner.
      const double line = std::abs(normal_.dot(Point2(p.x, p.y) - a_)) - normal_.lpNorm<1>() / 2;
      if (line < distance_) distance_ = std::min(distance_, segmentToSquare(a_, b_, p));
      return;
    }
  }

  const FreeSpace& free_;
  const Obstacles& obstacles_;
  double distance_;
  Point2 a_;
  Point2 b_;
  Point2 normal_;
  double length_ = 0;
};

}  // namespace

double pathClearancePx(const FreeSpace& free, const Obstacles& obstacles,
                       const std::vector<FinePoint>& path) {
  const std::int32_t least = leastSquaredDistance(free, path);
  if (least == kFarSquared) return std::numeric_limits<double>::infinity();
  const double distance = std::sqrt(least);
  if (distance > kExactPx) return distance - kTwoHalfDiagonals;
  // Between a touched pixel's point and the obstacle's nearest point lies less than between their
  // centres and half a diagonal. Where distances are between squares, a centre lies 1.42 farther.
  NearestObstacle nearest(free, obstacles, distance + 2 * kTwoHalfDiagonals);
  for (std::size_t i = 0; i < path.size(); ++i) nearest.look(path[i == 0 ? 0 : i - 1], path[i]);
  return nearest.distance();
}

}  // namespace agrid::planning
