// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/point2.h"

namespace agrid {

/// A corner of the outline of free space, image frame [px].
struct WallCorner {
  Point2 point;
  /// Along the walls to the corners before and after it [px]; neither is zero.
  std::array<Point2, 2> arms;
};

/// The corners of the outlines of free space and of the obstacles in it, after straightening by up
/// to 0.12 m or 1.3 pixels (Douglas and Peucker, 1973).
/// @param free_space  not 0: free
std::vector<WallCorner> findWallCorners(const cv::Mat1b& free_space, double resolution);

/// In which directions a building's walls run: the long ones tell how short ones are meant.
class WallDirections {
 public:
  /// @param corners  of a map of this resolution; walls under 1 m say nothing
  WallDirections(const std::vector<WallCorner>& corners, double resolution);

  /// The direction that a wall is meant to have: that of the most long walls, by the squares of
  /// their lengths, which the straightening of the outline could have turned it from.
  /// @param wall  from one end to the other [px]
  /// @return unit vector; if there are none, the wall's own direction, or nothing if the wall is
  ///         shorter than 0.5 m: a chipped corner or a column
  std::optional<Point2> align(const Point2& wall) const;

 private:
  static constexpr int kBins = 360;  ///< of half a degree
  static std::size_t binOf(int number) {
    return static_cast<std::size_t>((number + kBins) % kBins);
  }
  double weightAround(int bin) const { return weight_around_[binOf(bin)]; }

  double resolution_;
  std::array<double, kBins> weight_{};
  std::array<double, kBins> weight_around_{};   ///< of each bin and its neighbours
  std::array<double, kBins> weighted_angle_{};  ///< sum of weight times angle in [0, pi)
};

}  // namespace agrid
