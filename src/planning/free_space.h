// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "agrid/map/map_geometry.h"
#include "agrid/map/paged_array.h"
#include "planning/fine_point.h"
#include "planning/keep_out.h"

namespace agrid::planning {

/// A touched pixel's centre lies at most sqrt(2)/2 from a segment: at both ends of a jump along it.
constexpr double kTwoHalfDiagonals = 1.4143;

/// Of every pixel to the obstacles [px^2], row-major.
using SquaredDistances = PagedArray<std::int32_t, 10>;

/// Where a robot's centre may be: the one predicate of the search, of OMPL's validity checker and
/// of the tests. A pixel is free if its squared distance to the obstacles is greater than the
/// squared radius (in pixels, radius / resolution rounded to 1e-6, since a message's resolution is
/// a float32), it does not lie on the map's outermost ring, and in no forbidden area.
class FreeSpace {
 public:
  /// @param squared_distances  see obstacleDistances
  /// @param robot_radius  [m]
  FreeSpace(const MapGeometry& geometry, std::shared_ptr<const SquaredDistances> squared_distances,
            double robot_radius);

  const MapGeometry& geometry() const { return geometry_; }
  double radiusPx() const { return radius_px_; }
  /// The same radius with other obstacles.
  FreeSpace withDistances(std::shared_ptr<const SquaredDistances> squared_distances) const;
  /// The same with other forbidden areas. @param keep_out  null: none
  FreeSpace withKeepOut(std::shared_ptr<const KeepOut> keep_out) const;
  const std::shared_ptr<const KeepOut>& keepOut() const { return keep_out_; }
  /// The same for a radius that is smaller by `px`, without forbidden areas; all but the ring is
  /// free where none is left.
  FreeSpace narrowedLess(double px) const;

  bool isFree(Pixel p) const {
    return isInside(p) && isFarEnough(squaredDistance(p)) &&
           !(keep_out_ && keep_out_->holds(geometry_.index(p)));
  }
  /// Whether a pixel does not lie on the map's outermost ring.
  bool isInside(Pixel p) const {
    return p.x > 0 && p.y > 0 && p.x < geometry_.width - 1 && p.y < geometry_.height - 1;
  }
  /// Whether a squared distance to the obstacles suffices [px^2].
  bool isFarEnough(std::int32_t squared_distance) const { return squared_distance > limit_; }
  /// Of a pixel that the map contains [px^2].
  std::int32_t squaredDistance(Pixel p) const {
    return SquaredDistances::at(pages_, geometry_.index(p));
  }

  /// Whether every pixel whose closed square the segment touches is free. Exact: decided in
  /// integers, and pixels are passed over only where the distances prove them free. Free pixels are
  /// thereby connected by their sides; a diagonal step needs both pixels beside it.
  bool canSee(FinePoint a, FinePoint b) const;

 private:
  bool seesPastObstacles(FinePoint a, FinePoint b) const;

  MapGeometry geometry_;
  std::shared_ptr<const SquaredDistances> squared_distances_;
  const std::int32_t* const* pages_;  ///< of squared_distances_
  std::shared_ptr<const KeepOut> keep_out_;
  double radius_px_ = 0;
  std::int32_t limit_ = 0;  ///< free if the squared distance is greater
};

}  // namespace agrid::planning
