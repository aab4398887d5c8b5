// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/semantic_map.h"

namespace agrid {

/// An area that people drew.
struct GivenArea {
  std::string name;  ///< empty: it gets a default one
  std::string category;
  Properties properties;
};

/// What people have of a place from elsewhere.
struct GivenPlace {
  /// Row-major like the map: 0 = no area, k = areas[k - 1]; empty: no areas are given.
  std::vector<std::uint16_t> labels;
  std::vector<GivenArea> areas;
  std::vector<DoorTag> doors;      ///< their ids do not count
  std::vector<ObjectTag> objects;  ///< their ids do not count
};

/// Tags that say the same.
struct FittedTags {
  Knowledge knowledge;  ///< given tags only; the rest is found with them
  double mean_iou = 1;  ///< of each given area and the one that bears its tag, over its pixels
  std::vector<std::string> warnings;  ///< which of what was given tags cannot say
};

/// Finds tags with which `annotate` gives the areas that people drew as well as tags can: 'no door
/// here' where it would part one of them, doors where it would not part two, and a tag in each.
/// @param bare  the map, annotated with nothing known
/// @throws std::invalid_argument if `labels` is not of the map's size or has more than `areas`
FittedTags fitTags(const SemanticMap& bare, const GivenPlace& place);

}  // namespace agrid
