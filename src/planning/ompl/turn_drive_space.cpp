// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/turn_drive_space.h"

#include <cmath>

namespace agrid::planning {
namespace {

namespace ob = ompl::base;
using PoseState = ob::SE2StateSpace::StateType;

constexpr double kPi = 3.14159265358979323846;

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

}  // namespace

TurnDriveSpace::Move TurnDriveSpace::move(const ob::State* from, const ob::State* to) const {
  const Move forwards = moveAlong(from, to, false);
  if (!backwards_) return forwards;
  const Move back = moveAlong(from, to, true);
  return cost(back) < cost(forwards) - 1e-9 ? back : forwards;
}

TurnDriveSpace::Move TurnDriveSpace::moveAlong(const ob::State* from, const ob::State* to,
                                               bool back) const {
  const auto* a = from->as<PoseState>();
  const auto* b = to->as<PoseState>();
  const double dx = b->getX() - a->getX();
  const double dy = b->getY() - a->getY();
  const double length = std::hypot(dx, dy);
  if (length < 1e-9) return {wrapped(b->getYaw() - a->getYaw()), 0, 0};
  const double heading = std::atan2(dy, dx) + (back ? kPi : 0);
  return {wrapped(heading - a->getYaw()), back ? -length : length, wrapped(b->getYaw() - heading)};
}

double TurnDriveSpace::cost(const Move& move) const {
  return std::abs(move.length) +
         turn_cost_ * (std::abs(move.first_turn) + std::abs(move.second_turn));
}

double TurnDriveSpace::distance(const ob::State* from, const ob::State* to) const {
  return cost(move(from, to));
}

void TurnDriveSpace::interpolate(const ob::State* from, const ob::State* to, double t,
                                 ob::State* state) const {
  const Move m = move(from, to);
  const double yaw = from->as<PoseState>()->getYaw();
  double left = t * cost(m);
  const auto share = [&left](double part) {
    const double taken = part > 0 ? std::min(left / part, 1.0) : 1.0;
    left = std::max(0.0, left - part);
    return taken;
  };
  const double first = share(turn_cost_ * std::abs(m.first_turn));
  const double driven = share(std::abs(m.length));
  const double second = share(turn_cost_ * std::abs(m.second_turn));
  const double x = from->as<PoseState>()->getX();
  const double y = from->as<PoseState>()->getY();
  const double to_x = to->as<PoseState>()->getX();
  const double to_y = to->as<PoseState>()->getY();
  auto* result = state->as<PoseState>();
  result->setXY(x + driven * (to_x - x), y + driven * (to_y - y));
  result->setYaw(wrapped(yaw + first * m.first_turn + second * m.second_turn));
}

double TurnDriveSpace::getMaximumExtent() const {
  return ob::SE2StateSpace::getMaximumExtent() + 2 * kPi * turn_cost_;
}

}  // namespace agrid::planning
