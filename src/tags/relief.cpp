// SPDX-License-Identifier: BSD-3-Clause
#include "tags/relief.h"

#include <utility>

#include "tags/free_space.h"

namespace agrid {

Relief makeRelief(const OccupancyMap& map, const std::vector<Tag>& tags, const AreaParams& params) {
  Relief relief;
  AreaParams cleaning = params;
  // the paper takes the metric map as it is
  if (params.method == AreaMethod::kPaper) cleaning.max_clutter_diagonal = 0;
  relief.free_space = cleanFreeSpace(map, cleaning);
  for (const Tag& tag : tags) {
    const auto* door = std::get_if<DoorTag>(&tag);
    if (!door) continue;
    if (auto barrier = findBarrier(relief.free_space, map.geometry(), *door)) {
      relief.barriers.push_back(std::move(*barrier));
    } else {
      relief.warnings.push_back("door tag " + std::to_string(static_cast<std::uint32_t>(door->id)) +
                                " '" + door->name + "' lies outside free space and is not used");
    }
  }
  closeDoors(relief.barriers, relief.free_space);
  relief.height = distanceFromWalls(relief.free_space);
  return relief;
}

}  // namespace agrid
