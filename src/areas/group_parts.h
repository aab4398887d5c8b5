// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "areas/automatic_areas.h"

namespace agrid {

/// What a group of automatic areas is parted into by its doors.
struct GroupParts {
  cv::Rect window;                 ///< of the map's pixels
  cv::Mat1i part_of;               ///< in the window: 0 = none, k = parts[k - 1]; empty: all is one
  std::vector<Area> parts;         ///< the largest first, without what tags say
  std::vector<Segment> jambs_map;  ///< of the group's doors
};

/// The free pixels without a label that hang together with one, row-major indices; none if that one
/// is not free or has a label.
std::vector<std::size_t> islandAt(Pixel seed, const OccupancyMap& map, const PixelLabels& labels);

/// Parts a group at its doors. A door ends at the first wall; what it cuts off belongs to the part
/// beside it if it is too small for an area, and pixels of the door go to either side.
/// A group without doors is one part, for which no pixel is looked at but those of its outline.
/// A group without members is what hangs together with its seed of the free pixels that no
/// automatic area has.
GroupParts partsOf(const AreaGroup& group, const OccupancyMap& map,
                   const AutomaticAreas& automatic);

}  // namespace agrid
