// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/tag_proposal.h"

#include <algorithm>
#include <set>

#include "tags/persistence.h"
#include "tags/relief.h"

namespace agrid {
namespace {

/// Orders points of the map as a reader meets them: from the top, then from the left.
bool readsBefore(const Point2& a, const Point2& b) {
  return a.y() != b.y() ? a.y() > b.y() : a.x() < b.x();
}

std::vector<AreaTag> proposeSeeds(const OccupancyMap& map, const std::vector<Tag>& given,
                                  const AreaParams& params) {
  const MapGeometry& geometry = map.geometry();
  const Basins basins = findBasins(makeRelief(map, given, params).height);
  const auto area_of = mergeByPersistence(basins, geometry.resolution, params);
  std::vector<bool> is_seeded(basins.basins.size(), false);
  for (const Tag& tag : given) {
    const auto* area = std::get_if<AreaTag>(&tag);
    const auto pixel = area ? geometry.pixelAt(area->seed_map) : std::nullopt;
    if (!pixel) continue;
    const std::uint32_t basin = basins.of_pixel[geometry.index(*pixel)];
    if (basin != Basins::kNone) is_seeded[area_of[basin]] = true;
  }
  std::vector<AreaTag> seeds;
  for (std::size_t i = 0; i < basins.basins.size(); ++i) {
    if (area_of[i] != i || is_seeded[i]) continue;
    AreaTag seed;
    seed.seed_map = geometry.center(geometry.pixel(basins.basins[i].peak));
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<Tag> numbered(std::vector<AreaTag> seeds, const std::vector<Tag>& given) {
  std::stable_sort(seeds.begin(), seeds.end(), [](const AreaTag& a, const AreaTag& b) {
    return readsBefore(a.seed_map, b.seed_map);
  });
  std::set<AreaId> used;
  for (const Tag& tag : given) {
    if (const auto* area = std::get_if<AreaTag>(&tag)) used.insert(area->id);
  }
  std::vector<Tag> tags;
  std::uint32_t id = 0;
  for (AreaTag& seed : seeds) {
    do {
      seed.id = AreaId{++id};
    } while (used.count(seed.id) > 0);
    tags.emplace_back(std::move(seed));
  }
  return tags;
}

}  // namespace

std::vector<Tag> proposeTags(const OccupancyMap& map, const std::vector<Tag>& given,
                             const AreaParams& params) {
  validate(params);
  return numbered(proposeSeeds(map, given, params), given);
}

}  // namespace agrid
