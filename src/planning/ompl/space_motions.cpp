// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/space_motions.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include "planning/ompl/forward_space.h"
#include "planning/ompl/turn_drive_space.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;
using PlaneState = ob::RealVectorStateSpace::StateType;
using PoseState = ob::SE2StateSpace::StateType;

constexpr double kPi = 3.14159265358979323846;

/// Appends an arc or a straight line where a motion ends.
void extend(Movement& motion, Pose2& end, double length, double turn) {
  if (length == 0 && turn == 0) return;
  MotionPiece piece;
  piece.from = end;
  piece.length = length;
  piece.turn = turn;
  piece.is_arc = true;
  motion.add(piece);
  end = piece.at(1);
}

}  // namespace

SpaceMotions::SpaceMotions(ob::StateSpacePtr space)
    : space_(std::move(space)), kind_(kindOf(space_.get())) {
  turning_radius_ = measuredTurningRadius();
}

SpaceMotions::Kind SpaceMotions::kindOf(const ob::StateSpace* space) {
  if (dynamic_cast<const ob::ReedsSheppStateSpace*>(space) != nullptr) return Kind::kReedsShepp;
  if (dynamic_cast<const ob::DubinsStateSpace*>(space) != nullptr) return Kind::kDubins;
  if (dynamic_cast<const ForwardSpace*>(space) != nullptr) return Kind::kForward;
  if (dynamic_cast<const TurnDriveSpace*>(space) != nullptr) return Kind::kTurnDrive;
  if (dynamic_cast<const ob::SE2StateSpace*>(space) != nullptr) return Kind::kSlide;
  const auto* plane = dynamic_cast<const ob::RealVectorStateSpace*>(space);
  if (plane != nullptr && plane->getDimension() == 2) return Kind::kPlane;
  throw std::invalid_argument(
      "state space: must be RealVectorStateSpace of 2 dimensions, SE2StateSpace, "
      "DubinsStateSpace or ReedsSheppStateSpace");
}

/// OMPL keeps the radius to itself, but measures straight lines in it.
double SpaceMotions::measuredTurningRadius() const {
  if (kind_ == Kind::kForward) return space_->as<ForwardSpace>()->turningRadius();
  if (kind_ != Kind::kDubins && kind_ != Kind::kReedsShepp) return 0;
  ob::ScopedState<ob::SE2StateSpace> a(space_);
  ob::ScopedState<ob::SE2StateSpace> b(space_);
  a->setXY(0, 0);
  a->setYaw(0);
  b->setXY(1, 0);
  b->setYaw(0);
  if (kind_ == Kind::kDubins) {
    return 1 / space_->as<ob::DubinsStateSpace>()->dubins(a.get(), b.get()).length();
  }
  return 1 / space_->as<ob::ReedsSheppStateSpace>()->reedsShepp(a.get(), b.get()).length();
}

const ob::RealVectorBounds& SpaceMotions::bounds() const {
  if (isPlane()) return space_->as<ob::RealVectorStateSpace>()->getBounds();
  return space_->as<ob::SE2StateSpace>()->getBounds();
}

void SpaceMotions::setBounds(const ob::RealVectorBounds& bounds) {
  if (isPlane()) {
    space_->as<ob::RealVectorStateSpace>()->setBounds(bounds);
  } else {
    space_->as<ob::SE2StateSpace>()->setBounds(bounds);
  }
}

Pose2 SpaceMotions::pose(const ob::State* state) const {
  if (isPlane()) {
    const auto* values = state->as<PlaneState>()->values;
    return {{values[0], values[1]}, 0};
  }
  const auto* s = state->as<PoseState>();
  return {{s->getX(), s->getY()}, s->getYaw()};
}

void SpaceMotions::set(ob::State* state, const Pose2& pose) const {
  if (isPlane()) {
    state->as<PlaneState>()->values[0] = pose.position.x();
    state->as<PlaneState>()->values[1] = pose.position.y();
    return;
  }
  auto* s = state->as<PoseState>();
  s->setXY(pose.position.x(), pose.position.y());
  s->setYaw(std::remainder(pose.yaw, 2 * kPi));
}

Movement SpaceMotions::between(const ob::State* from, const ob::State* to) const {
  switch (kind_) {
    case Kind::kReedsShepp:
      return reedsShepp(from, to);
    case Kind::kDubins:
      return dubins(from, to);
    case Kind::kForward:
      return forward(from, to);
    case Kind::kTurnDrive:
      return turnDrive(from, to);
    case Kind::kPlane:
    case Kind::kSlide:
      break;
  }
  const Pose2 a = pose(from);
  const Pose2 b = pose(to);
  const Point2 along = b.position - a.position;
  MotionPiece piece;
  piece.from = a;
  piece.length = along.norm();
  piece.direction = std::atan2(along.y(), along.x());
  piece.turn = std::remainder(b.yaw - a.yaw, 2 * kPi);
  Movement motion;
  motion.add(piece);
  return motion;
}

Movement SpaceMotions::turnDrive(const ob::State* from, const ob::State* to) const {
  const TurnDriveSpace::Move move = space_->as<TurnDriveSpace>()->move(from, to);
  Movement motion;
  Pose2 end = pose(from);
  extend(motion, end, 0, move.first_turn);
  extend(motion, end, move.length, 0);
  extend(motion, end, 0, move.second_turn);
  return motion;
}

Movement SpaceMotions::forward(const ob::State* from, const ob::State* to) const {
  const ForwardCurve curve = space_->as<ForwardSpace>()->curve(from, to);
  Movement motion;
  Pose2 end = pose(from);
  for (std::size_t i = 0; i < 3; ++i) {
    extend(motion, end, curve.lengths[i] * turning_radius_, curve.lengths[i] * curve.turns[i]);
  }
  return motion;
}

Movement SpaceMotions::dubins(const ob::State* from, const ob::State* to) const {
  const auto* space = space_->as<ob::DubinsStateSpace>();
  auto path = space->dubins(from, to);
  Pose2 end = pose(from);
  if (space->hasSymmetricDistance()) {
    const auto back = space->dubins(to, from);
    if (back.length() < path.length()) {
      path = back;
      end = pose(to);
    }
  }
  Movement motion;
  for (int i = 0; i < 3; ++i) {
    const double v = path.length_[i];
    const auto type = path.type_[i];
    const double turn = type == ob::DubinsStateSpace::DUBINS_LEFT    ? v
                        : type == ob::DubinsStateSpace::DUBINS_RIGHT ? -v
                                                                     : 0.0;
    extend(motion, end, v * turning_radius_, turn);
  }
  return motion;
}

Movement SpaceMotions::reedsShepp(const ob::State* from, const ob::State* to) const {
  const auto path = space_->as<ob::ReedsSheppStateSpace>()->reedsShepp(from, to);
  Movement motion;
  Pose2 end = pose(from);
  for (int i = 0; i < 5; ++i) {
    const double v = path.length_[i];
    const auto type = path.type_[i];
    const double turn = type == ob::ReedsSheppStateSpace::RS_LEFT    ? v
                        : type == ob::ReedsSheppStateSpace::RS_RIGHT ? -v
                                                                     : 0.0;
    extend(motion, end, v * turning_radius_, turn);
  }
  return motion;
}

}  // namespace agrid::planning
