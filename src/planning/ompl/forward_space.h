// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <ompl/base/spaces/SE2StateSpace.h>

namespace agrid::planning {

/// Three arcs or straight lines, in turning radii and radians.
struct ForwardCurve {
  std::array<double, 3> lengths{};
  std::array<int, 3> turns{};  ///< 1 left, -1 right, 0 straight
  double length = 0;           ///< infinite if rounding leaves no curve that ends where it should
};

/// The shortest curve for a robot that drives forwards alone (Dubins 1957; formulas of Shkel and
/// Lumelsky 2001), and OMPL's view of it. OMPL's own DubinsStateSpace ends the process in an
/// assertion where two poses are so placed that a part of a curve vanishes.
class ForwardSpace : public ompl::base::SE2StateSpace {
 public:
  /// @param turning_radius  [m], positive
  explicit ForwardSpace(double turning_radius) : turning_radius_(turning_radius) {}

  double turningRadius() const { return turning_radius_; }
  ForwardCurve curve(const ompl::base::State* from, const ompl::base::State* to) const;

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }

 private:
  double turning_radius_;
};

}  // namespace agrid::planning
