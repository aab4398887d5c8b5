// SPDX-License-Identifier: BSD-3-Clause
#include "areas/seeded_flood.h"

#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "tags/disjoint_sets.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

constexpr std::uint32_t kNone = Basins::kNone;
constexpr std::uint32_t kSeveral = Basins::kNone - 1;

/// For each basin the seed whose area it belongs to, or kNone; where several seeds share a basin,
/// the number of seeds plus a number of their common area.
std::vector<std::uint32_t> floodBasins(const Basins& basins,
                                       const std::vector<std::uint32_t>& area_of,
                                       const std::vector<std::size_t>& seeds) {
  std::vector<std::uint32_t> seed_of(basins.basins.size(), kNone);
  for (std::uint32_t s = 0; s < seeds.size(); ++s) {
    std::uint32_t& seed = seed_of[basins.of_pixel[seeds[s]]];
    seed = seed == kNone ? s : kSeveral;
  }
  DisjointSets flooded(basins.basins.size());
  const auto flood = [&](bool within_areas) {
    for (const Saddle& saddle : basins.saddles) {
      if (within_areas && area_of[saddle.a] != area_of[saddle.b]) continue;
      std::uint32_t keeper = flooded.find(saddle.a);
      std::uint32_t other = flooded.find(saddle.b);
      if (keeper == other || (seed_of[keeper] != kNone && seed_of[other] != kNone)) continue;
      if (seed_of[keeper] == kNone) std::swap(keeper, other);
      flooded.unite(keeper, other);
    }
  };
  flood(true);
  flood(false);
  std::vector<std::uint32_t> result(seed_of.size());
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    const std::uint32_t root = flooded.find(i);
    const bool shared = seed_of[root] == kSeveral;
    result[i] = shared ? static_cast<std::uint32_t>(seeds.size()) + root : seed_of[root];
  }
  return result;
}

/// Hands the pixels that several seeds claim to the nearest of them by path.
void splitByDistance(std::vector<std::uint32_t>& labels, const std::vector<std::size_t>& seeds,
                     int columns) {
  using Front = std::tuple<float, std::size_t, std::uint32_t>;  // distance, pixel, seed
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  const auto isShared = [&](std::uint32_t l) { return l != kNone && l >= seeds.size(); };
  std::vector<std::uint32_t> shared_label(seeds.size(), kNone);
  for (std::uint32_t s = 0; s < seeds.size(); ++s) {
    if (!isShared(labels[seeds[s]])) continue;
    shared_label[s] = labels[seeds[s]];
    front.emplace(0.F, seeds[s], s);
  }
  const auto width = static_cast<std::size_t>(columns);
  const int rows = static_cast<int>(labels.size() / width);
  while (!front.empty()) {
    const auto [distance, i, seed] = front.top();
    front.pop();
    if (labels[i] != shared_label[seed]) continue;
    labels[i] = seed;
    const Pixel p{static_cast<int>(i % width), static_cast<int>(i / width)};
    for (std::size_t n = 0; n < kNeighbours.size(); ++n) {
      const Pixel q = p + kNeighbours[n];
      if (q.x < 0 || q.y < 0 || q.x >= columns || q.y >= rows) continue;
      const std::size_t j = static_cast<std::size_t>(q.y) * width + static_cast<std::size_t>(q.x);
      if (labels[j] != shared_label[seed]) continue;
      front.emplace(distance + (n < 4 ? 1.F : 1.41421356F), j, seed);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> floodFromSeeds(Basins basins, const std::vector<std::uint32_t>& area_of,
                                          const std::vector<std::size_t>& seeds, int columns) {
  const auto seed_of = floodBasins(basins, area_of, seeds);
  std::vector<std::uint32_t> labels = std::move(basins.of_pixel);
  for (std::uint32_t& label : labels) {
    if (label != kNone) label = seed_of[label];
  }
  splitByDistance(labels, seeds, columns);
  return labels;
}

}  // namespace agrid
