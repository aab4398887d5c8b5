// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planning/free_space.h"
#include "planning/obstacles.h"
#include "planning/ompl/footprint.h"
#include "planning/ompl/motion_piece.h"

namespace agrid::planning {

/// Decides where a robot may be and move, by the predicate of FreeSpace for a circle, or by an
/// outline, of which every pixel that it touches must be no obstacle. Motions are halved until the
/// distances prove a part free, so that no wall is too thin: true is returned only if the whole
/// motion is free; false may be wrong where it passes a pixel that is not free by less than
/// kMargin.
class SweptRobot {
 public:
  /// Poses between those checked, rounded to the fine lattice and joined by straight lines, stay
  /// within this of a motion that is free [px].
  static constexpr double kMargin = 1.0 / 64;

  explicit SweptRobot(FreeSpace free) : free_(std::move(free)) {}
  /// @param obstacles  must outlive this object
  SweptRobot(FreeSpace free, const Obstacles& obstacles, const Polygon& footprint_map);

  const FreeSpace& free() const { return free_; }
  /// Radius of the smallest circle around the robot [m].
  double outerRadius() const;

  /// @param pose  map frame
  bool isFree(const Pose2& pose_map) const;
  /// @param piece  map frame
  bool isFree(const MotionPiece& piece_map) const;
  /// Distance to obstacles beyond what the robot needs, from the stored distances [m]; negative if
  /// the pose is not free.
  double clearance(const Pose2& pose_map) const;

 private:
  struct Part;
  Pose2 toImage(const Pose2& pose_map) const;
  bool isPartFree(const MotionPiece& piece_px, const Part& part) const;
  bool isFarFromObstacles(const Pose2& pose_px, double reach) const;
  bool areTouchedFree(const Point2& low, const Point2& high) const;
  bool isOutlineFree(const Pose2& pose_px, double reach) const;
  bool isObstacle(Pixel p) const;
  /// How many columns on the next obstacle may lie: nearer ones than its distance can't.
  int freeColumnsFrom(Pixel p) const;

  FreeSpace free_;
  const Obstacles* obstacles_ = nullptr;
  std::optional<Footprint> outline_px_;
};

}  // namespace agrid::planning
