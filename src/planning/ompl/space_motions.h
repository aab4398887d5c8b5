// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include "planning/ompl/motion_piece.h"

namespace agrid::planning {

/// A motion between two states, in the map frame [m].
struct Movement {
  std::array<MotionPiece, 5> pieces;
  std::size_t count = 0;

  const MotionPiece* begin() const { return pieces.data(); }
  const MotionPiece* end() const { return pieces.data() + count; }
  void add(const MotionPiece& piece) { pieces[count++] = piece; }
};

/// What OMPL's state spaces for the plane mean: how a state is a pose of the map frame [m], and how
/// a robot moves from one state to another.
class SpaceMotions {
 public:
  /// @param space  RealVectorStateSpace of two dimensions, SE2StateSpace, DubinsStateSpace,
  ///               ReedsSheppStateSpace, TurnDriveSpace or ForwardSpace
  /// @throws std::invalid_argument for any other
  explicit SpaceMotions(ompl::base::StateSpacePtr space);

  bool isPlane() const { return kind_ == Kind::kPlane; }
  /// Of the space's curves, 0 where there are none [m].
  double turningRadius() const { return turning_radius_; }
  /// Of the positions [m].
  const ompl::base::RealVectorBounds& bounds() const;
  void setBounds(const ompl::base::RealVectorBounds& bounds);

  /// The heading is 0 in the plane.
  Pose2 pose(const ompl::base::State* state) const;
  void set(ompl::base::State* state, const Pose2& pose) const;
  Movement between(const ompl::base::State* from, const ompl::base::State* to) const;

 private:
  enum class Kind { kPlane, kSlide, kTurnDrive, kForward, kDubins, kReedsShepp };
  static Kind kindOf(const ompl::base::StateSpace* space);
  double measuredTurningRadius() const;
  Movement turnDrive(const ompl::base::State* from, const ompl::base::State* to) const;
  Movement forward(const ompl::base::State* from, const ompl::base::State* to) const;
  Movement dubins(const ompl::base::State* from, const ompl::base::State* to) const;
  Movement reedsShepp(const ompl::base::State* from, const ompl::base::State* to) const;

  ompl::base::StateSpacePtr space_;
  Kind kind_;
  double turning_radius_ = 0;
};

}  // namespace agrid::planning
