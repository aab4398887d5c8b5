// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// The map as areas are found on it with AreaMethod::kBorders: its walls along the axes of the
/// image, and no pixels much finer than 0.05 m. So what is measured in pixels at walls and corners
/// is the same however the map lies.
class AlignedView {
 public:
  /// @param map  must outlive the object. It is its own view if its walls run along its axes within
  ///             0.5 degrees and its pixels are over 1/30 m, and with the other methods.
  /// @param walls_yaw  direction of the walls, map frame, with the other one at right angles [rad]
  AlignedView(const OccupancyMap& map, const AreaParams& params, double walls_yaw);

  /// The same places in the same map frame, cut to what is free with a rim that is not. A pixel is
  /// free where at least 0.8 of it is: walls one pixel thick stay whole, wherever they fall between
  /// pixels.
  const OccupancyMap& map() const { return view_ ? *view_ : map_; }
  const MapGeometry& geometry() const { return map().geometry(); }
  bool isMapItself() const { return !view_; }

  /// Tags for the view: those that lie in free space on the map, but not quite on the view, are
  /// moved to the nearest free pixel of the view within 0.15 m or two pixels.
  std::vector<Tag> tagsOnView(const std::vector<Tag>& tags) const;

  /// Brings what was found on the view back to the map: each pixel takes the label of the view's
  /// pixel that holds its centre; free ones that get none there take that of the nearest one over
  /// the sides of free pixels.
  /// @param labels  of the view, row-major, Basins::kNone = no region
  std::vector<std::uint32_t> labelsOnMap(const std::vector<std::uint32_t>& labels) const;

 private:
  const OccupancyMap& map_;
  std::optional<OccupancyMap> view_;
};

}  // namespace agrid
