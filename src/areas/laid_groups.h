// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "areas/area_groups.h"
#include "areas/group_parts.h"

namespace agrid {

/// A group with its parts, and from where they are taken.
struct LaidGroup {
  AreaGroup group;
  const AreaGroup* former = nullptr;  ///< parted the same way before: its parts are taken over
  std::optional<GroupParts> parts;    ///< made anew
  std::vector<const AreaTag*> seats;  ///< the tag of each part, nullptr: none yet

  /// Neither made anew nor before: one automatic area as it was found.
  bool isAutomatic() const { return former == nullptr && !parts; }
};

/// The groups with their parts, and who sits where.
class LaidGroups {
 public:
  /// @param former  its areas and groups; nullptr: none
  LaidGroups(const OccupancyMap& map, const AutomaticAreas& automatic, const Grouping& grouping,
             const FormerTags* former);

  const std::vector<LaidGroup>& groups() const { return groups_; }
  std::vector<LaidGroup>& groups() { return groups_; }

  /// Offers tags the parts that hold their seeds: given ones first, then the lower id.
  void seat(const std::vector<AreaTag>& tags);

  /// What is known of a part's geometry: an area without what tags say.
  const Area& shapeOf(const LaidGroup& group, std::size_t part) const;

 private:
  struct Place {
    std::size_t group;
    std::size_t part;
  };
  std::optional<Place> placeOf(const Point2& seed_map) const;
  std::optional<std::size_t> partAt(const LaidGroup& group, Pixel pixel) const;

  const MapGeometry& geometry_;
  const AutomaticAreas& automatic_;
  const Grouping& grouping_;
  const FormerTags* former_;
  std::vector<LaidGroup> groups_;
  std::unordered_map<std::uint32_t, std::size_t> former_area_;  ///< index of the area with an id
};

}  // namespace agrid
