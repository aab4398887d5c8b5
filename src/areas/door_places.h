// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/map_geometry.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// The tag that would make a door: its middle, x leading through it.
DoorTag tagOf(const Door& door);

/// How well a tag means a door.
struct DoorFit {
  bool beside_middle = false;  ///< on the line between its jambs, but not in the middle
  double distance = 0;         ///< from its middle [m]
};

/// A tag means a door that leads the same way within 45 degrees, if it lies within two pixels or
/// 0.15 m of its middle, or else of the line between its jambs.
std::optional<DoorFit> fitOf(const DoorTag& tag, const Door& door, double resolution);

/// The doors that tags mean, none of them twice: given tags choose before automatic ones, those in
/// the middle of a door before others, then the nearest, then the lower id.
/// @return for each tag an index into `doors`, or none
std::vector<std::optional<std::size_t>> doorsMeant(const std::vector<const DoorTag*>& tags,
                                                   const std::vector<Door>& doors,
                                                   double resolution);

/// A stretch of a door with the labels on its sides.
struct DoorStretch {
  Segment jambs_map;
  std::array<std::uint16_t, 2> labels{};  ///< 0: none
};

/// The labels on both sides of doors.
class DoorSides {
 public:
  DoorSides(const MapGeometry& geometry, const PixelLabels& labels)
      : geometry_(geometry), labels_(labels) {}

  /// What most points of a door have behind and before them, up to a metre away.
  std::array<std::uint16_t, 2> beside(const Segment& jambs_map) const;

  /// A border between two automatic areas, in as many stretches as there are pairs of areas now.
  /// @param automatic  row-major labels of the automatic areas
  /// @param sides  labels of the two that it lies between
  std::vector<DoorStretch> along(const Segment& jambs_map, const PixelLabels& automatic,
                                 const std::array<std::uint16_t, 2>& sides) const;

 private:
  const MapGeometry& geometry_;
  const PixelLabels& labels_;
};

}  // namespace agrid
