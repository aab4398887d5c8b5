// SPDX-License-Identifier: BSD-3-Clause
#include "identity/reveal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "agrid/evaluation/perturbation.h"

namespace agrid::bench {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
constexpr double kStride = 1;  ///< between two places to look from [m]
constexpr int kMargin = 2;     ///< of unknown pixels around what was seen
constexpr int kRays = 1440;
constexpr std::uint32_t kWorn = 500;  ///< [1/10000] of the free pixels at obstacles
constexpr std::uint32_t kStray = 2;   ///< [1/10000] of the others

constexpr Pixel kSides[]{{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

class Robot {
 public:
  Robot(const OccupancyMap& map, Seeing seeing)
      : map_(map),
        seeing_(seeing),
        reach_(static_cast<int>(kReach / map.geometry().resolution)),
        stride_(static_cast<std::size_t>(std::max(1., kStride / map.geometry().resolution))),
        stop_of_(map.pixels().size(), kNever),
        from_(map.pixels().size()) {}

  std::vector<std::uint32_t> explore(Pixel start) {
    look(start);
    Pixel here = start;
    while (const auto path = toNearestUnseen(here)) {
      for (std::size_t i = stride_; i < path->size(); i += stride_) look((*path)[i]);
      here = path->back();
      look(here);
    }
    return std::move(stop_of_);
  }

 private:
  void see(Pixel p) {
    std::uint32_t& stop = stop_of_[map_.geometry().index(p)];
    if (stop == kNever) stop = stop_;
  }

  void look(Pixel here) {
    if (seeing_ == Seeing::kDisc) {
      for (int dy = -reach_; dy <= reach_; ++dy) {
        for (int dx = -reach_; dx <= reach_; ++dx) {
          const Pixel p{here.x + dx, here.y + dy};
          if (dx * dx + dy * dy <= reach_ * reach_ && map_.geometry().contains(p)) see(p);
        }
      }
    } else {
      for (int ray = 0; ray < kRays; ++ray) lookAlong(here, 2 * 3.14159265358979 * ray / kRays);
    }
    see(here);
    ++stop_;
  }

  void lookAlong(Pixel here, double angle) {
    for (double r = 0; r <= reach_; r += 0.5) {
      const Pixel p{static_cast<int>(std::lround(here.x + r * std::cos(angle))),
                    static_cast<int>(std::lround(here.y + r * std::sin(angle)))};
      if (!map_.geometry().contains(p)) return;
      see(p);
      if (!map_.isFree(p)) return;
    }
  }

  /// The way over the sides of free pixels, without its start.
  std::optional<std::vector<Pixel>> toNearestUnseen(Pixel here) {
    const MapGeometry& g = map_.geometry();
    std::fill(from_.begin(), from_.end(), kNever);
    std::vector<std::uint32_t> queue{static_cast<std::uint32_t>(g.index(here))};
    from_[queue[0]] = queue[0];
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t at = queue[i];
      if (stop_of_[at] == kNever) return wayTo(at);
      const Pixel p = g.pixel(at);
      for (const Pixel side : kSides) {
        const Pixel q{p.x + side.x, p.y + side.y};
        if (!g.contains(q) || !map_.isFree(q)) continue;
        const auto to = static_cast<std::uint32_t>(g.index(q));
        if (from_[to] != kNever) continue;
        from_[to] = at;
        queue.push_back(to);
      }
    }
    return std::nullopt;
  }

  std::vector<Pixel> wayTo(std::uint32_t at) const {
    std::vector<Pixel> way;
    for (; from_[at] != at; at = from_[at]) way.push_back(map_.geometry().pixel(at));
    std::reverse(way.begin(), way.end());
    return way;
  }

  const OccupancyMap& map_;
  Seeing seeing_;
  int reach_;  ///< [px]
  std::size_t stride_;
  std::uint32_t stop_ = 0;
  std::vector<std::uint32_t> stop_of_;
  std::vector<std::uint32_t> from_;
};

/// A pixel of the largest part of free space, the first in row-major order.
Pixel startOf(const OccupancyMap& map) {
  const MapGeometry& g = map.geometry();
  std::vector<bool> visited(map.pixels().size(), false);
  std::size_t best = 0;
  std::size_t best_size = 0;
  for (std::size_t first = 0; first < visited.size(); ++first) {
    if (visited[first] || map.pixels()[first] != Occupancy::kFree) continue;
    std::vector<std::size_t> part{first};
    visited[first] = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Pixel p = g.pixel(part[i]);
      for (const Pixel side : kSides) {
        const Pixel q{p.x + side.x, p.y + side.y};
        if (!g.contains(q) || !map.isFree(q) || visited[g.index(q)]) continue;
        visited[g.index(q)] = true;
        part.push_back(g.index(q));
      }
    }
    if (part.size() > best_size) {
      best_size = part.size();
      best = first;
    }
  }
  return g.pixel(best);
}

/// The same for the same numbers, on every machine.
std::uint32_t scrambled(std::uint64_t key) {
  key = (key ^ (key >> 31U)) * 0x7fb5d329728ea185ULL;
  key = (key ^ (key >> 27U)) * 0x81dadef4bc2dd44dULL;
  return static_cast<std::uint32_t>(key >> 33U);
}

}  // namespace

OccupancyGrid withNoise(const OccupancyGrid& grid, int step) {
  const OccupancyMap map(grid);
  OccupancyGrid result = grid;
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    if (map.pixels()[i] != Occupancy::kFree) continue;
    const std::uint32_t draw = scrambled(i * 1000003ULL + static_cast<std::uint64_t>(step)) % 10000;
    const bool worn = draw < kWorn && touchesObstacle(map, map.geometry().pixel(i));
    if (worn || draw < kStray) result.values[i] = 100;
  }
  return result;
}

Exploration::Exploration(const OccupancyMap& map, int steps, Seeing seeing)
    : map_(map), stop_of_(Robot(map, seeing).explore(startOf(map))) {
  std::vector<std::uint32_t> stops;
  for (std::size_t i = 0; i < stop_of_.size(); ++i) {
    if (map.pixels()[i] == Occupancy::kFree && stop_of_[i] != kNever) stops.push_back(stop_of_[i]);
  }
  std::sort(stops.begin(), stops.end());
  for (int step = 1; step <= steps; ++step) {
    last_stop_.push_back(stops[(stops.size() - 1) * static_cast<std::size_t>(step) /
                               static_cast<std::size_t>(steps)]);
  }
}

OccupancyGrid Exploration::seen(int step) const {
  const MapGeometry& whole = map_.geometry();
  const std::uint32_t last = last_stop_.at(static_cast<std::size_t>(step - 1));
  Pixel low{whole.width, whole.height};
  Pixel high{-1, -1};
  for (std::size_t i = 0; i < stop_of_.size(); ++i) {
    if (stop_of_[i] > last) continue;
    const Pixel p = whole.pixel(i);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  OccupancyGrid grid;
  low = {low.x - kMargin, low.y - kMargin};
  grid.geometry = {high.x - low.x + 1 + kMargin, high.y - low.y + 1 + kMargin, whole.resolution,
                   whole.map_from_image * Pose2{Point2(low.x, low.y) * whole.resolution, 0}};
  for (int y = 0; y < grid.geometry.height; ++y) {
    for (int x = 0; x < grid.geometry.width; ++x) {
      const Pixel p{low.x + x, low.y + y};
      const bool known = whole.contains(p) && stop_of_[whole.index(p)] <= last;
      const Occupancy o = known ? map_.at(p) : Occupancy::kUnknown;
      grid.values.push_back(o == Occupancy::kFree ? 0 : o == Occupancy::kOccupied ? 100 : -1);
    }
  }
  return withNoise(grid, step);
}

}  // namespace agrid::bench
