// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/point2.h"

namespace agrid {

/// Looks along straight lines through free space and through walls. Points and lengths are in
/// pixels of the image frame, pixel (x, y) covering [x, x + 1) x [y, y + 1); directions are unit
/// vectors. What lies beyond the map is wall.
class Sight {
 public:
  /// @param free_space  not 0: free
  /// @param height  distance of each pixel's centre from the nearest wall pixel's [px], see
  ///                distanceFromWalls; both must outlive the object
  Sight(const cv::Mat1b& free_space, const cv::Mat1f& height, double resolution);

  /// A length in metres as pixels.
  double pixels(double metres) const { return metres / resolution_; }
  double metres(double pixels) const { return pixels * resolution_; }

  bool isWall(const Point2& point) const;
  /// How far the line stays free, at most `reach`.
  double freeRun(const Point2& start, const Point2& direction, double reach) const;
  /// Whether a line has wall on it or right beside it at a distance from its start.
  bool isWallBeside(const Point2& start, const Point2& direction, double at) const;
  /// How far the line has wall on it or right beside it, at most `reach`; the farther, the more
  /// may the wall stray, as no line's direction is exact.
  double wallRun(const Point2& start, const Point2& direction, double reach) const;
  /// Share of the line that has wall on it or right beside it.
  double wallShare(const Point2& start, const Point2& direction, double length) const;
  /// What a line from `start` that ends at a wall after `length` meets.
  struct End {
    bool is_flat = false;  ///< the wall goes on to both sides of the line
    double slope = 0;      ///< of a flat wall against the perpendicular of the line
  };
  End endOf(const Point2& start, const Point2& direction, double length) const;

 private:
  /// How far around a point there is no wall for sure; 0 on walls.
  double safeStep(const Point2& point) const;

  const cv::Mat1b& free_space_;
  const cv::Mat1f& height_;
  double resolution_;
  double beside_;  ///< how far to the side of a line's start a wall still counts as on it [px]
};

}  // namespace agrid
