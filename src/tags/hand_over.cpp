// SPDX-License-Identifier: BSD-3-Clause
#include "tags/hand_over.h"

#include <utility>

#include "tags/basins.h"
#include "tags/pixel_neighbours.h"

namespace agrid {

void handOver(const std::vector<std::size_t>& open, const MapGeometry& geometry,
              std::vector<std::uint32_t>& labels) {
  std::vector<std::pair<std::size_t, std::uint32_t>> found;
  do {
    found.clear();
    for (const std::size_t i : open) {
      std::uint32_t label = labels[i];
      for (const Pixel step : kNeighbours) {
        const Pixel q = geometry.pixel(i) + step;
        if (label == Basins::kNone && geometry.contains(q)) label = labels[geometry.index(q)];
      }
      if (labels[i] == Basins::kNone && label != Basins::kNone) found.emplace_back(i, label);
    }
    for (const auto& [i, label] : found) labels[i] = label;
  } while (!found.empty());
}

}  // namespace agrid
