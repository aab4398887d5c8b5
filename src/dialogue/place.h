// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "agrid/geometry/pose2.h"
#include "agrid/semantic_map/thing_lookup.h"
#include "semantic_map/shape.h"

namespace agrid::dialogue {

/// A thing or the robot, as far as relations look at it.
struct Place {
  std::optional<Thing> thing;  ///< none: the robot
  Shape shape;
  Point2 center_map = Point2::Zero();
  std::vector<AreaId> areas;  ///< an area: itself; a door: on either side; else where it is in

  template <typename T>
  const T* as() const {
    const auto* held = thing ? std::get_if<const T*>(&*thing) : nullptr;
    return held ? *held : nullptr;
  }
};

Place placeOf(const SemanticMap& map, const Thing& thing);
Place placeOf(const SemanticMap& map, const Pose2& robot);

/// Whether there is an area that both are, or lie in, or lead to.
bool shareAnArea(const Place& a, const Place& b);

/// Whether the thing is the area that the other one lies in.
bool surrounds(const Place& area, const Place& inner);

}  // namespace agrid::dialogue
