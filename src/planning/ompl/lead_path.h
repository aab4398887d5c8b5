// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/util/RandomNumbers.h>

#include "agrid/geometry/pose2.h"

namespace agrid::planning {

/// The corners of a path that a robot could follow if it turned on the spot; map frame [m].
class LeadPath {
 public:
  /// @param corners  at least one
  explicit LeadPath(std::vector<Point2> corners);

  const std::vector<Point2>& corners() const { return corners_; }
  double length() const { return lengths_.back(); }
  /// Way along the path to a corner [m].
  double lengthAt(std::size_t corner) const { return lengths_[corner]; }
  /// @param along  way along the path [m]; beyond its ends, the end
  Point2 at(double along) const;
  /// Way along the path to its point that is nearest.
  double nearest(const Point2& point) const;
  /// Direction from a point before a place on the path to one behind it, as a robot would head that
  /// rounds the corners between.
  double heading(double along, double before, double behind) const;

 private:
  std::vector<Point2> corners_;
  std::vector<double> lengths_;
};

/// Draws poses near a lead.
class LeadSamples {
 public:
  /// @param scale  how far the poses spread, and over how long a way corners are rounded [m], such
  ///               as the robot's turning radius
  LeadSamples(const LeadPath& lead, double scale, std::uint32_t seed)
      : lead_(lead), scale_(scale), random_(seed) {}

  /// A pose near some place on the path.
  Pose2 any() { return near(random_.uniformReal(0, lead_.length())); }
  /// A pose around a place on the path: small spreads are as likely as large ones, since passages
  /// have any width.
  Pose2 near(double along);
  ompl::RNG& random() { return random_; }
  double scale() const { return scale_; }

 private:
  const LeadPath& lead_;
  double scale_;
  ompl::RNG random_;
};

}  // namespace agrid::planning
