// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/map_geometry.h"
#include "planning/fine_point.h"
#include "planning/portal.h"

namespace agrid::planning {

/// Forbidden areas: a robot's centre may not enter their pixels, however far obstacles are.
class KeepOut {
 public:
  /// @param former  shared where the same pixels are forbidden for certain; may be null
  /// @return null if no area is forbidden
  static std::shared_ptr<const KeepOut> of(const AreaMap& areas, const MapGeometry& geometry,
                                           const std::shared_ptr<const KeepOut>& former);
  /// The same with one area open; null if no other is forbidden.
  std::shared_ptr<const KeepOut> without(std::uint16_t label) const;

  /// Whether an area is forbidden, by its label.
  bool forbids(std::uint16_t label) const { return box_of_.count(label) != 0; }
  bool holds(std::size_t pixel_index) const { return held_[pixel_index]; }
  /// Whether a line touches the closed square of a pixel of these areas.
  bool isTouchedBy(FinePoint a, FinePoint b) const;
  /// Whether a pixel of these areas may be so near to a place; true if in doubt [px].
  bool mayBeNear(const Point2& place_px, double reach) const;

  /// Around the pixels of each area.
  std::vector<PixelBox> boxes() const;
  /// Around the pixels of which one of the two keeps out and the other does not; null is nothing.
  static std::vector<PixelBox> changedBoxes(const KeepOut* a, const KeepOut* b);

 private:
  KeepOut(const MapGeometry& geometry, PixelLabels labels, std::vector<bool> forbidden);
  bool anyBoxMeets(const Point2& low_px, const Point2& high_px) const;
  bool agreesWithin(const PixelBox& box, const KeepOut* other) const;

  MapGeometry geometry_;
  PixelLabels labels_;
  std::vector<bool> forbidden_;               ///< by label
  std::map<std::uint16_t, PixelBox> box_of_;  ///< of the forbidden labels
  std::vector<bool> held_;                    ///< by pixel
};

}  // namespace agrid::planning
