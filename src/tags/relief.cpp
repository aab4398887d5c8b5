// SPDX-License-Identifier: BSD-3-Clause
#include "tags/relief.h"

#include <utility>

#include "tags/free_space.h"

namespace agrid {

Relief makeRelief(const OccupancyMap& map, const std::vector<Tag>& tags, const AreaParams& params) {
  Relief relief;
  relief.free_space = cleanFreeSpace(map, params);
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
  for (const Barrier& barrier : relief.barriers) {
    for (const std::size_t i : barrier.pixels) relief.free_space.ptr()[i] = 0;
  }
  relief.height = distanceFromWalls(relief.free_space);
  return relief;
}

}  // namespace agrid
