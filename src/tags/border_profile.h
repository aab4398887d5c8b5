// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "agrid/geometry/segment.h"
#include "tags/borders.h"
#include "tags/openings.h"
#include "tags/relief.h"
#include "tags/sight.h"

namespace agrid {

/// What one side of a border looks like from the middle between its jambs [m].
struct SideProfile {
  /// At these distances from the border, how wide free space is along the border; 0 where a wall
  /// comes first.
  static constexpr std::array<double, 5> kDistances{0.25, 0.5, 1, 1.5, 2.5};
  std::array<double, kDistances.size()> widths{};
  double depth = 0;  ///< to the first wall, at most 15
};

/// What walls there are around a stretch of border between two regions; lengths in metres.
struct BorderProfile {
  Segment jambs_px;         ///< image frame [px]
  bool is_opening = false;  ///< an opening was found there, else a narrowing of the relief
  double width = 0;         ///< between the jambs
  double extent = 0;        ///< of the border itself
  double clearance = 0;     ///< of its place farthest from the walls
  std::array<double, 2> wall_runs{};  ///< of wall on the jambs' line beyond each jamb, at most 4
  /// How far the line goes on beyond each jamb over wall and openings along it, at most 8: a row of
  /// doors or of cubicles.
  std::array<double, 2> line_runs{};
  std::array<bool, 2> is_flat{};  ///< a jamb lies on a wall that runs across the line
  double walls_at_jambs = 0;  ///< share of the pixels within 0.5 of either jamb ('points around')
  std::array<SideProfile, 2> sides;  ///< towards region a and towards region b of the stretch
};

/// Looks at the walls around borders.
class BorderSurvey {
 public:
  /// All must outlive the object.
  BorderSurvey(const Relief& relief, const Openings& openings, const MapGeometry& geometry);

  /// @param labels  row-major; what the stretch lies between
  BorderProfile profileOf(const Stretch& stretch, const std::vector<std::uint32_t>& labels) const;
  const MapGeometry& geometry() const { return geometry_; }
  /// Distance of each pixel from the walls, row-major [px].
  const float* heights() const { return relief_.height.ptr<float>(); }

 private:
  float heightAt(const BorderPoint& point) const;
  Segment jambsOf(const Stretch& stretch, BorderProfile& profile) const;
  double lineRun(const Point2& jamb, const Point2& outward) const;
  bool isOpeningAlong(const Point2& point, const Point2& direction) const;
  void lookAlong(const Point2& direction, BorderProfile& profile) const;
  SideProfile lookAcross(const BorderProfile& profile, const Point2& direction,
                         const Point2& normal) const;
  double wallsAround(const Segment& jambs) const;

  const Relief& relief_;
  const Openings& openings_;
  MapGeometry geometry_;
  Sight sight_;
};

}  // namespace agrid
