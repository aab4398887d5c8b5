// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/geometry/segment.h"
#include "agrid/grid/a_grid.h"
#include "agrid/map/occupancy_map.h"
#include "agrid/tags/knowledge.h"
#include "agrid/tags/tag_proposal.h"

namespace agrid {

/// The areas that geometry alone says there are; see findAutomaticAreas.
struct AutomaticAreas;

/// A door that someone put where no border between automatic areas was.
struct GivenDoor {
  DoorId id{};
  Pose2 pose_map;    ///< its centre; x leads through it
  double width = 0;  ///< [m]; 0: up to the walls
};

/// Automatic areas that are one because someone said that there is no door between them, and what
/// the doors that someone put there part them into. Of no automatic area: free space that no
/// automatic area holds, but a given one.
struct AreaGroup {
  std::vector<std::uint16_t> members;  ///< labels of automatic areas, sorted
  std::vector<GivenDoor> doors;        ///< sorted by id
  Point2 seed_map = Point2::Zero();    ///< of a group without members [m]
  std::vector<AreaId> areas;           ///< what it is parted into, the largest first
  std::vector<Segment> jambs_map;      ///< of its doors; without length: where no area is
  /// In PixelLabels: of all parts, or without the first if there are members, whose labels it has.
  std::vector<std::uint16_t> slots;
};

/// What people and robots said, laid over the automatic areas.
struct LaidTags {
  AreaMap area_map;
  Knowledge knowledge;            ///< with a tag for every area and door, and what found no place
  std::vector<AreaGroup> groups;  ///< each automatic area is in one
};

/// What was laid before, of which the unchanged is taken over.
struct FormerTags {
  const AreaMap& area_map;
  const std::vector<AreaGroup>& groups;
};

/// Finds areas and doors by geometry alone: the same for whatever people say.
/// @throws std::invalid_argument if a parameter is out of range
std::shared_ptr<const AutomaticAreas> findAutomaticAreas(const OccupancyMap& map, const AGrid& grid,
                                                         const AreaParams& params);

/// Lays tags over automatic areas. An absent door joins the areas on both sides of the border it is
/// on. A given door on a border names it; elsewhere it parts the area that it lies in. An area tag
/// owns the area that holds its seed, given ones before automatic ones, then the lower id; given
/// ones that own none are pending, automatic ones are forgotten. Areas and doors without a tag get
/// an automatic one with a new id.
/// @param former  of the same automatic areas: what the tags do not change is taken from there;
///                the result is the same, bit for bit. nullptr: none
LaidTags layTags(const OccupancyMap& map, const AGrid& grid, const AutomaticAreas& automatic,
                 const FormerTags* former, Knowledge known);

}  // namespace agrid
