// SPDX-License-Identifier: BSD-3-Clause
#include "tags/persistence.h"

#include <algorithm>

#include "tags/disjoint_sets.h"

namespace agrid {

std::vector<std::uint32_t> mergeByPersistence(const Basins& basins, double resolution,
                                              const AreaParams& params) {
  const auto count = static_cast<std::uint32_t>(basins.basins.size());
  DisjointSets areas(count);
  std::vector<std::size_t> size_px(count);
  for (std::uint32_t i = 0; i < count; ++i) size_px[i] = basins.basins[i].size_px;
  const auto height = [&](std::uint32_t i) { return basins.basins[i].height; };
  const auto mergeWhere = [&](auto belong_together) {
    for (const Saddle& saddle : basins.saddles) {
      std::uint32_t high = areas.find(saddle.a);
      std::uint32_t low = areas.find(saddle.b);
      if (high == low) continue;
      if (height(low) > height(high) || (height(low) == height(high) && low < high)) {
        std::swap(high, low);
      }
      if (!belong_together(saddle.height, high, low)) continue;
      areas.unite(high, low);
      size_px[high] += size_px[low];
    }
  };

  const double min_prominence_px = params.min_prominence / resolution;
  mergeWhere([&](float saddle, std::uint32_t, std::uint32_t low) {
    return saddle >= params.merge_ratio * height(low) || height(low) - saddle < min_prominence_px;
  });
  const double min_clearance_px = params.min_area_clearance / resolution;
  const double min_size_px = params.min_area_size / (resolution * resolution);
  mergeWhere([&](float, std::uint32_t high, std::uint32_t low) {
    return static_cast<double>(std::min(size_px[high], size_px[low])) < min_size_px ||
           height(low) < min_clearance_px;
  });

  std::vector<std::uint32_t> area_of(count);
  for (std::uint32_t i = 0; i < count; ++i) area_of[i] = areas.find(i);
  return area_of;
}

}  // namespace agrid
