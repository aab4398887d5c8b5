// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/spaces/SE2StateSpace.h>

namespace agrid::planning {

/// Poses between which a robot turns on the spot, drives straight along its heading, and turns on
/// the spot again. What OMPL's SE2StateSpace lacks: there a robot also slides sideways.
class TurnDriveSpace : public ompl::base::SE2StateSpace {
 public:
  /// @param backwards  it may also drive backwards, and does where it turns less by that
  /// @param turn_cost  distance that turning by one radian counts as [m]
  TurnDriveSpace(bool backwards, double turn_cost) : backwards_(backwards), turn_cost_(turn_cost) {}

  struct Move {
    double first_turn = 0;   ///< [rad]
    double length = 0;       ///< negative: backwards
    double second_turn = 0;  ///< [rad]
  };
  Move move(const ompl::base::State* from, const ompl::base::State* to) const;

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return backwards_; }
  bool hasSymmetricInterpolate() const override { return backwards_; }
  /// Turning counts beside the way.
  double getMaximumExtent() const override;

 private:
  Move moveAlong(const ompl::base::State* from, const ompl::base::State* to, bool back) const;
  double cost(const Move& move) const;

  bool backwards_;
  double turn_cost_;
};

}  // namespace agrid::planning
