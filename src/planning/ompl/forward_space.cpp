// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/forward_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/ompl/motion_piece.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;
using PoseState = ob::SE2StateSpace::StateType;

constexpr double kTwoPi = 2 * 3.14159265358979323846;
/// A curve may miss its end by so many turning radii.
constexpr double kTolerance = 1e-6;

/// In [0, 2 pi); a hair below a full circle is none.
double positive(double angle) {
  const double rest = angle - kTwoPi * std::floor(angle / kTwoPi);
  return rest > kTwoPi - 1e-9 ? 0 : rest;
}

MotionPiece pieceOf(const ForwardCurve& curve, std::size_t i, const Pose2& from, double share) {
  MotionPiece piece;
  piece.from = from;
  piece.length = share * curve.lengths[i];
  piece.turn = piece.length * curve.turns[i];
  piece.is_arc = true;
  return piece;
}

/// The goal as seen from the start, in turning radii, the goal lying on the x axis.
struct Task {
  double d;
  double a;  ///< heading of the start
  double b;  ///< heading of the goal
  double sa = std::sin(a);
  double sb = std::sin(b);
  double ca = std::cos(a);
  double cb = std::cos(b);
};

class Shortest {
 public:
  explicit Shortest(const Task& task) : task_(task) {
    best_.length = std::numeric_limits<double>::infinity();
    sameTurns(1);
    sameTurns(-1);
    oppositeTurns(1);
    oppositeTurns(-1);
    threeTurns(1);
    threeTurns(-1);
  }
  const ForwardCurve& best() const { return best_; }

 private:
  /// Left-straight-left for 1, right-straight-right for -1: the mirror image.
  void sameTurns(int side) {
    const double x = task_.d + side * (task_.sa - task_.sb);
    const double y = task_.cb - task_.ca;
    // Without a straight part, the two turns are one, wherever they meet.
    const bool straight = std::hypot(x, y) > 1e-9;
    const double along = straight ? side * std::atan2(y, x) : task_.a;
    offer(
        {positive(side * (along - task_.a)), std::hypot(x, y), positive(side * (task_.b - along))},
        {side, 0, side});
  }
  void oppositeTurns(int side) {
    const double x = task_.d + side * (task_.sa + task_.sb);
    const double y = -task_.ca - task_.cb;
    const double square = x * x + y * y - 4;
    if (square < -1e-9) return;
    const double straight = std::sqrt(std::max(square, 0.0));
    const double along = side * std::atan2(y, x) + side * std::atan2(2, straight);
    offer({positive(side * (along - task_.a)), straight, positive(side * (along - task_.b))},
          {side, 0, -side});
  }
  void threeTurns(int side) {
    const double x = task_.d + side * (task_.sa - task_.sb);
    const double y = task_.ca - task_.cb;
    const double cosine = (8 - x * x - y * y) / 8;
    if (std::abs(cosine) > 1) return;
    const double middle = kTwoPi - std::acos(cosine);
    const double first = positive(-side * task_.a - std::atan2(y, x) + middle / 2);
    offer({first, middle, positive(side * (task_.b - task_.a) - first + middle)},
          {side, -side, side});
  }

  void offer(const std::array<double, 3>& lengths, const std::array<int, 3>& turns) {
    const ForwardCurve curve{lengths, turns, lengths[0] + lengths[1] + lengths[2]};
    if (!(curve.length < best_.length)) return;
    Pose2 end{Point2::Zero(), task_.a};
    for (std::size_t i = 0; i < 3; ++i) end = pieceOf(curve, i, end, 1).at(1);
    const double missed = (end.position - Point2(task_.d, 0)).norm() +
                          std::abs(std::remainder(end.yaw - task_.b, kTwoPi));
    if (missed <= kTolerance * (1 + task_.d)) best_ = curve;
  }

  Task task_;
  ForwardCurve best_;
};

Pose2 poseOf(const ob::State* state) {
  const auto* s = state->as<PoseState>();
  return {{s->getX(), s->getY()}, s->getYaw()};
}

}  // namespace

ForwardCurve ForwardSpace::curve(const ob::State* from, const ob::State* to) const {
  const Pose2 a = poseOf(from);
  const Pose2 b = poseOf(to);
  const Point2 way = (b.position - a.position) / turning_radius_;
  const double along = std::atan2(way.y(), way.x());
  return Shortest(Task{way.norm(), a.yaw - along, b.yaw - along}).best();
}

double ForwardSpace::distance(const ob::State* from, const ob::State* to) const {
  return curve(from, to).length * turning_radius_;
}

void ForwardSpace::interpolate(const ob::State* from, const ob::State* to, double t,
                               ob::State* state) const {
  if (t >= 1) return copyState(state, to);
  const ForwardCurve whole = curve(from, to);
  if (t <= 0 || !std::isfinite(whole.length)) return copyState(state, from);
  Pose2 pose{Point2::Zero(), poseOf(from).yaw};
  double left = t * whole.length;
  for (std::size_t i = 0; i < 3 && left > 0; ++i) {
    if (whole.lengths[i] == 0) continue;
    pose = pieceOf(whole, i, pose, std::min(1.0, left / whole.lengths[i])).at(1);
    left -= whole.lengths[i];
  }
  const Point2 position = poseOf(from).position + turning_radius_ * pose.position;
  state->as<PoseState>()->setXY(position.x(), position.y());
  state->as<PoseState>()->setYaw(std::remainder(pose.yaw, kTwoPi));
}

}  // namespace agrid::planning
