// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// How areas are found.
enum class AreaMethod {
  kBorders,      ///< free space cut at every opening and narrowing, then each border judged by what
                 ///< people have drawn
  kPersistence,  ///< watershed of the distance transform, merged by persistence
  kPaper         ///< narrow passages as doors, centroids as seeds, watershed, opening (paper, 3.2)
};

/// How users call the methods, in the order of AreaMethod.
inline constexpr std::array<const char*, 3> kAreaMethodNames{"borders", "persistence", "paper"};

/// Constants of the paper's own method (AreaMethod::kPaper), which gives no values for them.
struct PassageParams {
  double min_width = 0.5;    ///< narrower gaps are no passages [m]; a wheelchair's least door
  double max_width = 1.3;    ///< wider gaps are no passages [m]; wide single doors
  double max_skew_deg = 12;  ///< 'regularity': largest angle to the image's axes, in [0, 45]
  double min_spacing = 0.8;  ///< 'proximity': of two passages nearer than this the better stays [m]
  double support_reach = 0.5;  ///< 'points around': distance from a jamb in which they count [m]
  double min_support = 0.4;    ///< obstacle points there, as a length of wall at each jamb [m]
  double opening = 0.3;        ///< diameter of the opening's structuring element [m]
};

/// How areas and doors are found; lengths in metres, so that maps of any resolution behave alike.
struct AreaParams {
  AreaMethod method = AreaMethod::kBorders;
  /// Obstacles whose bounding box has a smaller diagonal are clutter such as chair legs, unless
  /// they touch the map's border [m]. 1.5 scores the same, 0.5 costs .045 of MCC on furnished maps.
  double max_clutter_diagonal = 1.0;
  /// Free islands below this size belong to no area [m^2].
  double min_island_size = 0.25;
  /// Two regions are areas of their own if it is this sure that people would draw a border between
  /// them, in [0, 1] (kBorders). Lower: more areas.
  double min_separation = 0.7;
  /// A narrowing parts two areas if it is below this share of the lower one's clearance, in (0, 1]
  /// (kPersistence).
  double merge_ratio = 0.75;
  /// ... and below it by at least this much [m]; 0.05 is a pixel of the usual map.
  double min_prominence = 0.05;
  /// Smaller areas join the neighbour that they open to the widest [m^2].
  double min_area_size = 1.0;
  /// Areas whose widest place is nearer to the walls join a neighbour too, and are left out if they
  /// have none [m]: rays of the laser through windows and gaps.
  double min_area_clearance = 0.15;
  /// Borders between areas up to this width are doors, wider ones passages [m]; of 632 borders
  /// between rooms drawn by people 95 % are below 1.97.
  double max_door_width = 2.6;
  /// Shorter borders between areas are no doors [m].
  double min_border_length = 0.2;
  PassageParams passages;
};

/// Refuses parameters that make no sense.
/// @throws std::invalid_argument naming field, value and bound
void validate(const AreaParams& params);

/// Finds area seeds and doors by geometry alone (paper, 3.2: automatic tagging), for the parts of
/// the map that `given` says nothing about. The seeds lie at the point of their area farthest from
/// its walls (kPersistence) or at its centroid (kPaper); doors are proposed by kPaper only.
/// @param given  area seeds: their areas get no other; doors: closed like walls
/// @param walls_yaw  direction of the walls, as the grid is laid, map frame [rad]; kBorders looks
/// at
///                   the map along them. None: along the axes of its image.
/// @return automatic tags without names, ordered from the top of the map to its bottom; their ids
///         are the lowest ones from 1 that `given` does not use
/// @throws std::invalid_argument if a parameter is out of range
std::vector<Tag> proposeTags(const OccupancyMap& map, const std::vector<Tag>& given,
                             const AreaParams& params = {}, std::optional<double> walls_yaw = {});

}  // namespace agrid
