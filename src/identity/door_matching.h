// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/identity/recognition.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// A door that was known, and may be one of those of the new map.
struct DoorClaim {
  DoorTag tag;
  bool waits = false;
};

/// Where a door is.
struct DoorPlace {
  Pose2 pose_map;    ///< the middle between its jambs; x leads through it
  double width = 0;  ///< [m]
};

DoorPlace placeOf(const Door& door);

/// Which door is which.
struct DoorMatches {
  std::vector<std::optional<std::size_t>> claim_of_door;
  std::vector<std::string> doubt;  ///< by claim: why it has no door, a clause; empty if it has one
};

/// Each door is at most one of the claims: the given one that it was annotated with, else by where
/// its middle is, its direction, its width and the areas beside it. Doors that say that there is
/// none (`absent`) are passed over.
/// @param former_areas  of each claim: beside it; AreaId{0}: none
/// @param fresh_areas   of each door, by the ids that the areas keep; AreaId{0}: none, or a new one
DoorMatches matchDoors(const std::vector<DoorClaim>& claims,
                       const std::vector<std::array<AreaId, 2>>& former_areas,
                       const std::vector<Door>& doors,
                       const std::vector<std::array<AreaId, 2>>& fresh_areas,
                       const RecognitionParams& params);

}  // namespace agrid
